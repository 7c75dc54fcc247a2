"""``graph``: the neighbour graph without the edges that cross a crease."""

from __future__ import annotations

from dataclasses import dataclass, field
from os import fspath
from typing import TYPE_CHECKING, Literal

import numpy as np
import numpy.typing as npt

from lineament import _lineament
from lineament._extraction import LINES, Extraction, Progress, of
from lineament._network import Path
from lineament._parameters import ParamsLike, settings, signed
from lineament._points import PointsLike
from lineament._progress import watcher
from lineament._scan import as_scan

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from lineament._keywords import Parameters


@dataclass(frozen=True, eq=False)
class Graph:
    """The result of :func:`graph`."""

    edges: npt.NDArray[np.uint32]
    """``(E, 2)`` edges along the surface as rows of the points: the lesser first, in ascending order. Points that were dropped and
    clutter have none; of points at one place one has them all."""
    cut: npt.NDArray[np.uint32]
    """``(C, 2)`` edges that lead from one side of a line to the other, in the same order."""
    extraction: Extraction = field(repr=False)
    """The lines at which the graph was cut."""

    def write(self, path: Path, *, all: bool = False) -> None:
        """Writes points and edges, as ``lineament graph -o``: whole or not at all, in the format of the extension.

        Parameters
        ----------
        path
            ``.ply``, ``.npz``, ``.csv`` or ``.json``.
        all
            Writes the edges that cross a line too, with a column ``cut`` that is 1 for them.

        Raises
        ------
        OutputError
            If no format has the extension, or the file cannot be written.
        """
        found = self.extraction
        _lineament.write_graph(fspath(path), found.scan, found.network.provenance, self.edges, self.cut, all)

    def __repr__(self) -> str:
        return f"Graph({len(self.edges)} edges along the surface, {len(self.cut)} across a line)"


@signed(*LINES)
def graph(
    points: PointsLike,
    *,
    graph: Literal["riemannian", "delaunay"] = "riemannian",
    progress: Progress = False,
    params: ParamsLike | None = None,
    **parameters: Unpack[Parameters],
) -> Graph:
    """The neighbour graph of points, parted into the edges along the surface and those that cross a crease or a border, as
    ``lineament graph`` (Gumhold 2001, section 5.1): whatever walks along the former stays on its face.

    Parameters
    ----------
    points, progress, params, parameters
        As of :func:`extract`.
    graph
        ``riemannian``, the ``neighbors_k`` nearest of each point, or ``delaunay``, the edges of the triangles that a filter of
        Delaunay triangles leaves (section 2.1), about three for each point, none between parts that lie apart.

    Raises
    ------
    ParameterError, CloudError, TypeError, ValueError
        As :func:`extract`.
    """
    scan = as_scan(points)
    with watcher(progress) as watch:
        raw = _lineament.graph(scan.points, settings(params, parameters), graph, watch, scan.folds)
    return Graph(raw["edges"], raw["cut"], of(raw["extraction"], scan))
