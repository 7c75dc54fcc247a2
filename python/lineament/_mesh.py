"""``mesh``: triangles whose edges follow creases and borders."""

from __future__ import annotations

from dataclasses import dataclass, field
from os import fspath
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from lineament import _lineament
from lineament._errors import ParameterError
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
class Mesh:
    """The result of :func:`mesh`: a manifold."""

    vertices: Points
    """``(V, 3)`` points of the input, and points on lines."""
    kinds: npt.NDArray[np.uint8]
    """``(V,)`` 0 for a point of the input, 1 on a crease, 2 on a border, 3 at a corner."""
    triangles: npt.NDArray[np.uint32]
    """``(T, 3)`` vertices of each triangle, counter-clockwise seen from outside."""
    open_edges: int
    """The number of edges of one triangle: 0 of a closed mesh."""
    extraction: Extraction = field(repr=False)
    """The lines."""

    def write(self, path: Path) -> None:
        """Writes the mesh, as ``lineament mesh -o``: whole or not at all, in the format of the extension.

        Parameters
        ----------
        path
            ``.ply``, ``.obj``, ``.stl``, ``.off`` or ``.glb``.

        Raises
        ------
        OutputError
            If no format has the extension, or the file cannot be written.
        """
        files = self.extraction.scan.files
        _lineament.write_mesh(fspath(path), files, self.vertices, self.kinds, self.triangles)

    def __repr__(self) -> str:
        return f"Mesh({len(self.triangles)} triangles over {len(self.vertices)} vertices, {self.open_edges} open edges)"


@signed(*LINES)
def mesh(
    points: PointsLike,
    *,
    step: float | None = None,
    enrich: bool = True,
    progress: Progress = False,
    params: ParamsLike | None = None,
    **parameters: Unpack[Parameters],
) -> Mesh:
    """Makes a mesh of points whose edges follow their creases and borders, turned outwards, as ``lineament mesh`` (Gumhold 2001,
    sections 2.1, 5.1 and 5.2). It goes through the points: noise stays in it.

    Parameters
    ----------
    points, progress, params, parameters
        As of :func:`extract`.
    step
        Distance between the vertices along a line, in spacings of the points there; 0.7 unless given.
    enrich
        Whether to put vertices on the lines, and to keep triangles from joining two sides of one.

    Raises
    ------
    ParameterError, CloudError, TypeError, ValueError
        As :func:`extract`; the first for a step without vertices on the lines, too.
    """
    if step is not None and not enrich:
        raise ParameterError("step: there are no vertices on the lines with enrich=False")
    scan = as_scan(points)
    with watcher(progress) as watch:
        raw = _lineament.mesh(scan.points, settings(params, parameters), step, enrich, watch, scan.folds)
    found = of(raw["extraction"], scan)
    return Mesh(raw["vertices"], raw["kinds"], raw["triangles"], raw["open_edges"], found)
