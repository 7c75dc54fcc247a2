"""``section``: the curves in which planes meet the surface of points."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from os import fspath
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from lineament import _lineament
from lineament._extraction import Progress
from lineament._curves import BSpline, spline
from lineament._network import Path, Provenance
from lineament._parameters import ParamsLike, section_settings, signed
from lineament._points import PointsLike
from lineament._progress import watcher
from lineament._scan import Scan, as_scan, provenance
from lineament._stack import Stack

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from lineament._keywords import SectionParameters
    from lineament._lineament import RawContour, RawPiece, RawSection

PieceKind: TypeAlias = Literal["line", "arc", "circle", "ellipse", "spline"]


@dataclass(frozen=True, eq=False)
class Piece:
    """One curve of a contour. What a kind does not have is ``None``."""

    kind: PieceKind
    start: npt.NDArray[np.float64]
    """``(3,)`` first point, in the frame of the input."""
    end: npt.NDArray[np.float64]
    """``(3,)`` last point; the first point again for a circle."""
    worst: float
    """Greatest distance of a point of the contour from it, unit of the input."""
    center: npt.NDArray[np.float64] | None
    """``(3,)`` of an arc, circle or ellipse."""
    radius: float | None
    """Of an arc or circle, unit of the input."""
    major: npt.NDArray[np.float64] | None
    """``(3,)`` greater half axis of an ellipse, from the centre."""
    minor: float | None
    """Length of the lesser half axis of an ellipse, unit of the input."""
    sweep_deg: float | None
    """Angle swept by an arc, change of the parameter of an ellipse (360 of a whole one), degrees, positive counter-clockwise seen against the axis."""
    curve: BSpline | None
    """Of a spline."""


@dataclass(frozen=True, eq=False)
class Contour:
    """One curve of a section."""

    points: npt.NDArray[np.float64]
    """``(M, 3)`` in order, in the frame of the input; the first is not repeated at the end of a closed contour. Outer contours run
    counter-clockwise seen against the axis, holes clockwise."""
    corners: list[int]
    """Ascending indices of those points that are corners."""
    closed: bool
    parent: int | None
    """The contour of the same section that closely surrounds this one."""
    depth: int
    """Number of contours around this one: even for an outer one, odd for a hole."""
    area: float
    """Enclosed area, squared unit of the input: positive for outer contours, negative for holes, 0 for open ones."""
    length: float
    draft_deg: float | None
    """Median angle between the wall and the axis, degrees, positive where the contour grows along the axis; ``None`` for open
    contours."""
    steepest_deg: float
    """The angle between the wall and the axis, degrees, that nine tenths of the contour stay under, of either sign."""
    centroid: npt.NDArray[np.float64]
    """``(3,)`` of the enclosed area, of the line for an open contour."""
    pieces: list[Piece]
    """The contour as lines, arcs, circles, ellipses and splines, end to end; empty without ``fit``."""

    @property
    def polyline(self) -> npt.NDArray[np.float64]:
        """``(M, 3)`` points of an open contour, ``(M + 1, 3)`` of a closed one with the first repeated at the end."""
        return np.concatenate([self.points, self.points[:1]]) if self.closed else self.points


@dataclass(frozen=True, eq=False)
class Section:
    """The curves in one plane."""

    plane: int
    """Index of the plane."""
    height: float
    """Its position along the axis, unit of the input."""
    slab: tuple[float, float] | None
    """The part of the axis that the section stands for; ``None`` for planes at given positions."""
    points: int
    """Number of points of the input in the slab."""
    contours: list[Contour]
    """The curves, longest first."""
    missing: str | None
    """Why there is no curve; ``None`` where there is one."""

    def __repr__(self) -> str:
        return f"Section(at {self.height:.6g}, {len(self.contours)} contours)"


@dataclass(frozen=True, eq=False)
class Sections:
    """The result of :func:`section`."""

    axes: npt.NDArray[np.float64]
    """``(3, 3)`` unit vectors as rows: two in the planes, then the axis."""
    counted_from: Literal["origin", "lowest", "floor"]
    """The place that positions are counted from."""
    zero: float
    """Its position along the axis, unit of the input."""
    heights: npt.NDArray[np.float64]
    """``(P,)`` position of each plane along the axis, unit of the input."""
    spacing: float
    """Median spacing of the points, unit of the input."""
    noise: float
    """Estimated standard deviation of the points from the surface, in spacings."""
    dropped: int
    """Points left out because a coordinate was not finite."""
    merged: int
    """Points merged into an exact duplicate."""
    clutter: int
    """Points left out because they lie on no surface."""
    sections: list[Section]
    """One for each plane."""
    stack: Stack
    """What the stack of slices shows; empty without ``fit``."""
    provenance: Provenance = field(repr=False)
    scan: Scan = field(repr=False)
    """The points, as they were given."""
    _cut: _lineament.Cut = field(repr=False)

    def write(self, path: Path, *, millimetres: float | None = None, unit: str | None = None) -> None:
        """Writes the sections, as ``lineament section -o``: whole or not at all, in the format of the extension.

        Parameters
        ----------
        path
            ``.json``, ``.dxf``, ``.svg``, ``.obj``, ``.ply``, ``.geojson``, ``.gpkg``, or ``.html`` (a report for browsers, with
            the points).
        millimetres
            Millimetres of a drawing for one unit of the input; without, it is fitted to 200 mm.
        unit
            Unit of the coordinates, which DXF states: mm, cm, m, in or ft. Nothing is scaled by it.

        Raises
        ------
        OutputError
            If no format has the extension, or the file cannot be written.
        """
        self._cut.write(fspath(path), self.scan, self.provenance, millimetres, unit)

    def __iter__(self) -> Iterator[Section]:
        return iter(self.sections)

    def __len__(self) -> int:
        return len(self.sections)

    def __repr__(self) -> str:
        return f"Sections({len(self.sections)} planes, {sum(len(s.contours) for s in self.sections)} contours)"


@signed("section")
def section(
    points: PointsLike,
    *,
    progress: Progress = False,
    params: ParamsLike | None = None,
    **parameters: Unpack[SectionParameters],
) -> Sections:
    """Cuts points by planes: the curves in which these meet the surface.

    Parameters
    ----------
    points, progress
        As of :func:`extract`.
    params
        As of :func:`extract`; the section ``section`` counts.
    parameters
        Parameters of the program under ``section.``, such as ``axis="auto"``, ``planes="count:20"`` or ``fit=True``. A number for
        ``planes`` is so many, a sequence positions along the axis; a sequence for ``axis`` is a vector.

    Raises
    ------
    ParameterError, CloudError, TypeError, ValueError
        As :func:`extract`.
    """
    scan = as_scan(points)
    with watcher(progress) as watch:
        raw = _lineament.section(scan.points, section_settings(params, parameters), watch)
    return Sections(
        raw["axes"],
        raw["counted_from"],
        raw["zero"],
        raw["heights"],
        raw["spacing"],
        raw["noise"],
        raw["dropped"],
        raw["merged"],
        raw["clutter"],
        [_section(one) for one in raw["sections"]],
        Stack._of(raw["stack"]),
        provenance(scan),
        scan,
        raw["cut"],
    )


def _section(raw: RawSection) -> Section:
    contours = [_contour(contour) for contour in raw["contours"]]
    return Section(raw["plane"], raw["height"], raw["slab"], raw["points"], contours, raw["missing"])


def _contour(raw: RawContour) -> Contour:
    fields: dict[str, Any] = {**raw, "pieces": [_piece(piece) for piece in raw["pieces"]]}
    return Contour(**fields)


def _piece(raw: RawPiece) -> Piece:
    fields: dict[str, Any] = {**raw, "curve": spline(raw["curve"])}
    return Piece(**fields)
