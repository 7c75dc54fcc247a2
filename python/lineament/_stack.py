"""What a stack of slices shows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from lineament._lineament import RawStack

RunKind: TypeAlias = Literal["extrusion", "taper", "revolution"]


@dataclass(frozen=True, eq=False)
class Run:
    """Like contours through neighbouring slices. Lengths are in the unit of the input; what a kind does not have is ``None``."""

    kind: RunKind
    hole: bool
    """Whether the contours are holes."""
    start: float
    """Where it begins along the axis."""
    end: float
    """Where it ends along the axis."""
    range_error: tuple[float, float]
    """Errors of both."""
    residual: float
    """Mean distance of the contours from the feature."""
    center: npt.NDArray[np.float64]
    """``(3,)`` centroid of the middle contour; the centre of a round one."""
    contours: list[tuple[int, int]]
    """Planes and indices in their sections, ascending by height."""
    radius: float | None
    """Of a round extrusion, of a round taper at its start, the least of a revolution."""
    greatest_radius: float | None
    """Of a revolution."""
    angle_deg: float | None
    """Of a taper: mean angle between the walls and the axis, degrees; positive where the outline grows along the axis."""
    apex: float | None
    """Of a taper: height at which the outline would shrink to nothing; infinite where it does nowhere."""


@dataclass(frozen=True, eq=False)
class Mirror:
    """A mirror plane that holds the axis of the slices."""

    point: npt.NDArray[np.float64]
    """``(3,)`` on the plane."""
    normal: npt.NDArray[np.float64]
    """``(3,)`` unit vector."""
    planes: int
    """Slices that mirror themselves in it."""
    residual: float
    """Mean distance between contours and mirrored contours, unit of the input."""


@dataclass(frozen=True)
class Repeat:
    """Runs of one outline at several places."""

    runs: list[int]
    residual: float
    """Mean distance of their outlines, one laid over the other, unit of the input."""


@dataclass(frozen=True, eq=False)
class Stack:
    """The features of a stack of slices."""

    runs: list[Run]
    """By height, then by contour."""
    mirrors: list[Mirror]
    repeats: list[Repeat]

    @classmethod
    def _of(cls, raw: RawStack) -> Stack:
        return cls(
            [Run(**run) for run in raw["runs"]],
            [Mirror(**mirror) for mirror in raw["mirrors"]],
            [Repeat(**repeat) for repeat in raw["repeats"]],
        )

    def __repr__(self) -> str:
        return f"Stack({len(self.runs)} runs, {len(self.mirrors)} mirrors, {len(self.repeats)} repeats)"
