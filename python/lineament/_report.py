"""Classes of points, and the report of a result."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from lineament._lineament import RawReport


class PointClass(IntEnum):
    """The class of a point."""

    SMOOTH = 0
    """On no line."""
    CREASE = 1
    """On a crease."""
    BORDER = 2
    """On a border."""
    CORNER = 3
    """At a place where lines meet, end or turn."""
    CLUTTER = 4
    """On no surface: leaves, stray returns, veils between surfaces."""


@dataclass(frozen=True)
class Report:
    """Counts, estimates and times of an extraction."""

    read: int
    """Points given."""
    dropped: int
    """Points left out because a coordinate was not finite."""
    merged: int
    """Points merged into an exact duplicate."""
    points: int
    """Points kept."""
    scattered: int
    """Points on no surface that fill a volume: leaves, rubble, spray."""
    stray: int
    """Other points on no surface."""
    thinned: int
    """Points represented by another: in rows, and where noise exceeds the spacing."""
    spacing: float
    """Mean distance to the six nearest neighbours, corrected for noise; unit of the input."""
    noise: float
    """Standard deviation of the noise along the surface normal; unit of the input."""
    stages: dict[str, float]
    """Seconds that each stage took."""
    settings: dict[str, str]
    """The values of parameters derived from the data."""
    used: dict[str, str]
    """The value of every parameter that the method reads, by its key in the program."""
    notes: list[str]
    """Notes on the result."""

    @classmethod
    def _of(cls, raw: RawReport) -> Report:
        fields: dict[str, Any] = {**raw, "stages": dict(raw["stages"]), "settings": dict(raw["settings"]), "used": dict(raw["used"])}
        return cls(**fields)
