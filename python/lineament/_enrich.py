"""``enrich``: points along creases and borders, and at corners."""

from __future__ import annotations

from dataclasses import dataclass, field
from os import fspath
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from lineament import _lineament
from lineament._extraction import LINES, Extraction, Progress, of
from lineament._network import Path
from lineament._parameters import ParamsLike, settings, signed
from lineament._points import Points, PointsLike
from lineament._progress import watcher
from lineament._scan import as_scan

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from lineament._keywords import Parameters


@dataclass(frozen=True, eq=False)
class Enriched:
    """The result of :func:`enrich`. It is taken for points itself: those of the input, followed by those on lines."""

    added: Points
    """``(K, 3)`` the points on lines: those at nodes, then those along the lines in their order."""
    kinds: npt.NDArray[np.uint8]
    """``(K,)`` class of each of them: 1 crease, 2 border, 3 corner."""
    sources: npt.NDArray[np.uint32]
    """``(K,)`` the point of the input next to each, as a row."""
    extraction: Extraction = field(repr=False)
    """The lines."""

    @property
    def points(self) -> Points:
        """``(N + K, 3)`` the points of the input in their order, then those on lines."""
        return np.concatenate([self.extraction.scan.points, self.added])

    @property
    def classes(self) -> npt.NDArray[np.uint8]:
        """``(N + K,)`` class of each of :attr:`points`: see :class:`PointClass`."""
        return np.concatenate([self.extraction.classes, self.kinds])

    def write(self, path: Path, *, added: bool = False) -> None:
        """Writes the points with their classes and attributes, as ``lineament enrich -o``: whole or not at all, in the format of the
        extension. A point on a line has the attributes of the point next to it, but no normal.

        Parameters
        ----------
        path
            ``.npy`` (the positions alone), ``.npz``, ``.parquet``, ``.ply``, ``.las``, ``.laz``, ``.pcd``, ``.xyz``, ``.csv``, or
            ``.html`` (a report for browsers).
        added
            Writes the points on lines alone.

        Raises
        ------
        OutputError
            If no format has the extension, or the file cannot be written.
        """
        found, of_lines = self.extraction, (self.added, self.kinds, self.sources)
        _lineament.write_enriched(fspath(path), found.scan, found.classes, of_lines, added)

    def __len__(self) -> int:
        return len(self.extraction.scan) + len(self.added)

    def __repr__(self) -> str:
        return f"Enriched({len(self)} points, {len(self.added)} of them on lines)"


@signed(*LINES)
def enrich(
    points: PointsLike,
    *,
    step: float = 1.0,
    progress: Progress = False,
    params: ParamsLike | None = None,
    **parameters: Unpack[Parameters],
) -> Enriched:
    """Adds points along the creases and borders of points, and at the corners, as ``lineament enrich`` (Gumhold 2001, section 5.2):
    a scanner hardly ever hits an edge, and programs that know nothing of edges cut them off.

    Parameters
    ----------
    points, progress, params, parameters
        As of :func:`extract`.
    step
        Distance between the points along a line, in spacings of the points there.

    Raises
    ------
    ParameterError, CloudError, TypeError, ValueError
        As :func:`extract`.
    """
    scan = as_scan(points)
    with watcher(progress) as watch:
        raw = _lineament.enrich(scan.points, settings(params, parameters), step, watch, scan.folds)
    return Enriched(raw["points"], raw["kinds"], raw["sources"], of(raw["extraction"], scan))
