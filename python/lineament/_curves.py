"""Curves of strips: B-splines, and lines, arcs, circles and ellipses with how well they are known."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from lineament._lineament import RawCurve, RawTyped, Typed

CurveKind: TypeAlias = Literal["line", "arc", "circle", "ellipse", "b-spline"]


@dataclass(frozen=True, eq=False)
class BSpline:
    """A B-spline curve, clamped or periodic."""

    degree: int
    """Polynomial degree; 3 unless the strip is too short for it."""
    knots: npt.NDArray[np.float64]
    """Non-decreasing knots. Clamped: ``len(controls) + degree + 1`` of them, the first and the last ``degree + 1`` equal.
    Periodic: ``len(controls) + 1`` of them, one period."""
    controls: npt.NDArray[np.float64]
    """``(C, 3)`` control points, in the frame and unit of the input."""
    periodic: bool
    """Whether the curve closes smoothly on itself."""

    def __repr__(self) -> str:
        kind = "periodic" if self.periodic else "clamped"
        return f"BSpline({kind}, degree {self.degree}, {len(self.controls)} control points)"


@dataclass(frozen=True, eq=False)
class Curve:
    """One typed curve of a strip, in the frame and unit of the input. What a kind does not have, and what the points do not
    determine, is ``None``."""

    kind: CurveKind
    start: npt.NDArray[np.float64]
    """``(3,)`` first point, the last one of the curve before it."""
    end: npt.NDArray[np.float64]
    """``(3,)`` last point."""
    first: int
    """The first of the sources of the strip that it stands for, as an index into them."""
    last: int
    """The last one; at most ``first`` where the curve runs over the end of a closed strip."""
    deviation: float
    """Root mean square distance of these points from it."""
    center: npt.NDArray[np.float64] | None
    """``(3,)`` of an arc, circle or ellipse."""
    normal: npt.NDArray[np.float64] | None
    """``(3,)`` unit vector of an arc or ellipse, which run counter-clockwise about it, or a circle."""
    radius: float | None
    """Of an arc or circle."""
    major: npt.NDArray[np.float64] | None
    """``(3,)`` greater half axis of an ellipse, from the centre."""
    minor: float | None
    """Length of the lesser half axis of an ellipse."""
    sweep_deg: float | None
    """Angle swept by an arc, change of the parameter of an ellipse (360 of a whole one), degrees."""
    spline: BSpline | None
    """Of a B-spline."""
    offset_sigma: float | None
    """Standard deviation of a line across it at its middle, in either direction."""
    direction_sigma_deg: float | None
    """Standard deviation of the direction of a line, degrees, in either direction."""
    radius_sigma: float | None
    """Standard deviation of the radius."""
    normal_sigma_deg: float | None
    """Standard deviation of the normal, degrees: the root of the sum of both squares."""
    turn_sigma_deg: float | None
    """Standard deviation of the turn of an ellipse in its plane, degrees."""
    covariance: npt.NDArray[np.float64] | None
    """``(4, 4)`` covariance of centre and radius of an arc or circle: x, y, z, r; ``(5, 5)`` of an ellipse: x, y, z, greater and lesser
    half axis."""
    _typed: Typed = field(repr=False)

    def __repr__(self) -> str:
        radius = "" if self.radius is None else f", radius {self.radius:.6g}"
        sigma = "" if self.radius_sigma is None else f" ± {self.radius_sigma:.2g}"
        return f"Curve({self.kind}{radius}{sigma})"


def spline(raw: RawCurve | None) -> BSpline | None:
    """A B-spline of the compiled part."""
    return None if raw is None else BSpline(**raw)


def curve(raw: RawTyped) -> Curve:
    """A typed curve of the compiled part."""
    fields: dict[str, Any] = {**raw, "spline": spline(raw["spline"])}
    return Curve(_typed=fields.pop("typed"), **fields)
