"""Points of any kind as an ``(N, 3)`` array of float64, without importing the libraries that they come from."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol, TypeAlias, cast

import numpy as np
import numpy.typing as npt

Points: TypeAlias = npt.NDArray[np.float64]
"""``(N, 3)`` float64, C-contiguous, in the frame and unit of the input."""


class HasPoints(Protocol):
    """Whatever has ``points``: clouds of Open3D, meshes and clouds of PyVista, scans read by this package."""

    @property
    def points(self) -> Any: ...


class HasVertices(Protocol):
    """Whatever has ``vertices``: clouds and meshes of trimesh."""

    @property
    def vertices(self) -> Any: ...


class HasCoordinates(Protocol):
    """Whatever has scaled ``x``, ``y`` and ``z``: LAS data of laspy, frames of pandas and Polars."""

    @property
    def x(self) -> Any: ...
    @property
    def y(self) -> Any: ...
    @property
    def z(self) -> Any: ...


PointsLike: TypeAlias = "npt.ArrayLike | HasPoints | HasVertices | HasCoordinates | Mapping[str, Any]"
"""Points as they are taken: arrays and nested sequences of shape ``(N, 3)`` or ``(N, 3 + M)``, of which the first three columns
are read; clouds and meshes of Open3D, PyVista and trimesh; frames of pandas or Polars and LAS data of laspy, by their columns
``x``, ``y``, ``z``; mappings with these keys."""


def as_points(points: PointsLike) -> Points:
    """The points as an array that the compiled part reads where it is.

    Returns
    -------
    ``(N, 3)`` float64, C-contiguous and aligned: the array itself if it is so, else a copy. Masked values are NaN.

    Raises
    ------
    ValueError
        If the shape is another.
    TypeError
        If the values are no real numbers.
    """
    values = np.asarray(_found(points))
    if values.ndim != 2 or values.shape[1] < 3:
        raise ValueError(f"points of shape {values.shape}: expected (N, 3), a row for each point")
    if values.shape[1] > _WIDE and values.shape[0] < values.shape[1]:
        raise ValueError(f"points of shape {values.shape}: the array lies on its side; pass its transpose, with a row for each point")
    if values.dtype.kind not in "fiu":
        raise TypeError(f"points of type {values.dtype}: expected real numbers")
    return np.require(values[:, :3], np.float64, ["C_CONTIGUOUS", "ALIGNED"])


_WIDE = 16
"""Columns beyond which there must be more rows: else an array lies on its side, as in NPY files."""


def _found(points: Any) -> Any:
    """The array, or what becomes one, that an object holds its points in."""
    if isinstance(points, np.ma.MaskedArray):
        return cast("Any", points).astype(np.float64).filled(np.nan)
    if isinstance(points, np.ndarray):
        return cast("npt.NDArray[Any]", points)
    if isinstance(points, Mapping) or hasattr(points, "columns"):
        return _columns(points)
    # The records of LAS data are integers: its scaled coordinates are meant.
    if all(hasattr(points, axis) for axis in "xyz"):
        return np.column_stack([np.asarray(axis) for axis in (points.x, points.y, points.z)])
    if hasattr(points, "points"):
        return points.points
    return points.vertices if hasattr(points, "vertices") else points


def _columns(table: Any) -> npt.NDArray[Any]:
    """The columns ``x``, ``y`` and ``z`` of a table, in capitals too."""
    columns = cast("Any", table if isinstance(table, Mapping) else table.columns)
    names: dict[str, Any] = {str(name): name for name in columns}
    for wanted in ("xyz", "XYZ"):
        if all(axis in names for axis in wanted):
            return np.column_stack([np.asarray(cast("Any", table)[names[axis]]) for axis in wanted])
    raise ValueError(f"a table with the columns {', '.join(names) or 'none'}: expected x, y and z among them")
