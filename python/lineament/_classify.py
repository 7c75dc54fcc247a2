"""``classify``: a class and a score for each point."""

from __future__ import annotations

from dataclasses import dataclass, field
from os import fspath
from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from lineament import _lineament
from lineament._extraction import LINES, Progress, run
from lineament._network import Network, Path
from lineament._parameters import ParamsLike, settings, signed
from lineament._points import PointsLike
from lineament._progress import watcher
from lineament._report import Report
from lineament._scan import Scan, as_scan

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from lineament._keywords import Parameters

Detector: TypeAlias = Literal[
    "projection", "surface-variation", "mean-curvature", "normal-difference", "multiscale-variation", "persistence"
]
"""Measures with a threshold of their own: see ``lineament help classify``."""


@dataclass(frozen=True, eq=False)
class Classification:
    """The result of :func:`classify`."""

    classes: npt.NDArray[np.uint8]
    """``(N,)`` class of each point of the input, in its order: see :class:`PointClass`. Dropped points are smooth."""
    scores: npt.NDArray[np.float32]
    """``(N,)`` score of each point of the input, 0 to 1; NaN for dropped points, 0 for clutter."""
    report: Report
    network: Network | None
    """The lines; ``None`` with a detector, which finds none."""
    scan: Scan = field(repr=False)
    """The points, as they were given."""

    def write(self, path: Path) -> None:
        """Writes the points with class, score and attributes, as ``lineament classify -o``: whole or not at all, in the format of
        the extension.

        Parameters
        ----------
        path
            ``.npy`` (the classes alone), ``.npz``, ``.parquet``, ``.ply``, ``.las``, ``.laz``, ``.pcd``, ``.xyz``, ``.csv``, or
            ``.html`` (a report for browsers).

        Raises
        ------
        OutputError
            If no format has the extension, or the file cannot be written.
        """
        _lineament.write_points(fspath(path), self.scan, self.classes, self.scores, self.network)

    def __repr__(self) -> str:
        return f"Classification({len(self.classes)} points)"


@signed(*LINES)
def classify(
    points: PointsLike,
    *,
    detector: Detector | None = None,
    progress: Progress = False,
    params: ParamsLike | None = None,
    **parameters: Unpack[Parameters],
) -> Classification:
    """Classifies each point: 0 smooth, 1 crease, 2 border, 3 corner, 4 clutter.

    Parameters
    ----------
    points, progress, params, parameters
        As of :func:`extract`.
    detector
        Classifies by this measure and its threshold alone, without lines: points above it get 1, all others 0.

    Raises
    ------
    ParameterError, CloudError, TypeError, ValueError
        As :func:`extract`.
    """
    given = settings(params, parameters)
    if detector is None:
        found = run(points, given, progress)
        return Classification(found.classes, found.scores, found.report, found.network, found.scan)
    scan = as_scan(points)
    with watcher(progress) as watch:
        raw = _lineament.mark(scan.points, given, detector, watch)
    return Classification(raw["classes"], raw["scores"], Report._of(raw["report"]), None, scan)
