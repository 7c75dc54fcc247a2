"""``clean``: the points on surfaces, without leaves, stray returns and veils between surfaces."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from os import fspath
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from lineament import _lineament
from lineament._extraction import Progress
from lineament._network import Path
from lineament._parameters import ParamsLike, settings, signed
from lineament._points import Points, PointsLike
from lineament._progress import watcher
from lineament._report import Report
from lineament._scan import Scan, as_scan

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from lineament._keywords import Parameters


@dataclass(frozen=True, eq=False)
class Cleaned:
    """The result of :func:`clean`. It is taken for points itself: those on surfaces, with their attributes and reference system."""

    surface: npt.NDArray[np.uint32]
    """Indices of the points of the input on surfaces, ascending: all finite points but clutter, duplicates among them."""
    clutter: npt.NDArray[np.uint32]
    """Indices of the points of the input on no surface, ascending."""
    report: Report
    scan: Scan = field(repr=False)
    """The points, as they were given."""

    @property
    def points(self) -> Points:
        """``(M, 3)`` the points on surfaces, in the order of the input."""
        return self.scan.points[self.surface]

    @property
    def kept(self) -> Scan:
        """The points on surfaces with their attributes."""
        attributes = {name: column[self.surface] for name, column in self.scan.attributes.items()}
        return replace(self.scan, points=self.points, attributes=attributes)

    def write(self, path: Path, *, label: bool = False) -> None:
        """Writes the points on surfaces, as ``lineament clean -o``: whole or not at all, in the format of the extension.

        Parameters
        ----------
        path
            ``.npy`` (the positions alone), ``.npz``, ``.parquet``, ``.ply``, ``.las``, ``.laz``, ``.pcd``, ``.xyz``, ``.csv``, or
            ``.html`` (a report for browsers).
        label
            Writes all points instead, with a column ``class``: 0 on a surface or not finite, 4 clutter. NPY holds the classes; in LAS
            and LAZ clutter also gets classification 7, noise.

        Raises
        ------
        OutputError
            If no format has the extension, or the file cannot be written.
        """
        scan, clutter = (self.scan, self.clutter) if label else (self.kept, None)
        _lineament.write_scan(fspath(path), scan, clutter)

    def __len__(self) -> int:
        return len(self.surface)

    def __repr__(self) -> str:
        return f"Cleaned({len(self.surface)} points on surfaces, {len(self.clutter)} of clutter)"


@signed("neighbors", "surface")
def clean(
    points: PointsLike,
    *,
    progress: Progress = False,
    params: ParamsLike | None = None,
    **parameters: Unpack[Parameters],
) -> Cleaned:
    """Leaves out the points that lie on no surface: leaves, stray returns, veils between surfaces.

    Points that are not finite are left out too. ``surface_clutter`` has no effect.

    Parameters
    ----------
    points, progress, params, parameters
        As of :func:`extract`.

    Raises
    ------
    ParameterError, CloudError, TypeError, ValueError
        As :func:`extract`.
    """
    scan = as_scan(points)
    with watcher(progress) as watch:
        raw = _lineament.clean(scan.points, settings(params, parameters), watch)
    return Cleaned(raw["surface"], raw["clutter"], Report._of(raw["report"]), scan)
