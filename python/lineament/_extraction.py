"""``extract``: from points to their feature network."""

from __future__ import annotations

import html
from collections.abc import Callable
from dataclasses import dataclass, field
from os import fspath
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
import numpy.typing as npt

from lineament import _lineament
from lineament._network import Network, Path
from lineament._parameters import ParamsLike, settings, signed
from lineament._patches import Patches
from lineament._points import PointsLike
from lineament._progress import watcher
from lineament._relations import Regularised, Relation, regularised, relation
from lineament._report import Report
from lineament._scan import Scan, as_scan, provenance

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from lineament._keywords import Parameters

Progress: TypeAlias = "bool | Callable[[str, float], object]"
"""``True`` for a bar by tqdm, or a function that is called with the name of a stage and the share of it that is done, 0 to 1."""


@dataclass(frozen=True, eq=False)
class Extraction:
    """The result of :func:`extract`."""

    network: Network
    """The lines."""
    classes: npt.NDArray[np.uint8]
    """``(N,)`` class of each point of the input, in its order: see :class:`PointClass`. Dropped points are smooth."""
    scores: npt.NDArray[np.float32]
    """``(N,)`` score of each point of the input, 0 to 1; NaN for dropped points, 0 for clutter."""
    clutter: npt.NDArray[np.uint32]
    """Indices of the points of the input that lie on no surface, ascending."""
    patches: Patches | None
    """The patches between the lines; ``None`` if they were not looked for."""
    relations: list[Relation]
    """The relations between the typed curves of the lines."""
    regularised: Regularised | None
    """How far ``relations_regularise=True`` moved nodes and curves; ``None`` without."""
    report: Report
    scan: Scan = field(repr=False)
    """The points, as they were given."""
    _found: _lineament.Found = field(repr=False)

    @property
    def parameters(self) -> dict[str, str]:
        """The value of every parameter that the method reads, by its key in the program."""
        return self.report.used

    def write(
        self, path: Path, *, view: str = "auto", millimetres: float | None = None, unit: str | None = None
    ) -> None:
        """Writes the lines, as ``lineament extract -o``: see :meth:`Network.write`. A report (``.html``) shows the points too."""
        labels = None if self.patches is None else self.patches.labels
        marks = self.classes, labels
        self._found.write(fspath(path), self.scan, self.network.provenance, marks, (view, millimetres, unit))

    def _repr_html_(self) -> str:
        notes = "".join(f"<p>Note: {html.escape(note)}</p>" for note in self.report.notes)
        return self.network._repr_html_() + notes

    def __repr__(self) -> str:
        return f"Extraction({self.network!r}, {len(self.classes)} points)"


LINES = ("method", "neighbors", "surface", "penalty", "projection", "edgelets", "spanning", "repair", "segments", "recover", "spline", "relations", "patches")
"""The sections of the table of parameters that concern lines."""


@signed(*LINES)
def extract(
    points: PointsLike,
    *,
    progress: Progress = False,
    params: ParamsLike | None = None,
    **parameters: Unpack[Parameters],
) -> Extraction:
    """Finds the feature lines of points: creases where faces meet, borders where the surface ends.

    No parameter needs to be set. The lock of the interpreter is released; Ctrl-C ends the call at once. Points in an ``(N, 3)``
    array of float64 in C order are read where they are, without a copy, and must not be changed meanwhile.

    Parameters
    ----------
    points
        ``(N, 3)`` points in any unit, in any order: see :data:`PointsLike`. Rows that are not finite are left out and counted.
    progress
        ``True`` for a bar by tqdm, or a function that is called with the name of a stage and the share of it that is done.
    params
        Parameters as a mapping of keys to values, or of sections to such mappings; as the document of a JSON result, whose
        ``parameters`` are taken; or as the path of a TOML file that ``lineament params`` printed, or of a JSON result. Keyword
        arguments go over it.
    parameters
        Parameters of the program by their keys, with ``_`` in place of the dot: ``penalty_fold_deg=15``. ``help(lineament.extract)``
        lists them with their defaults, :func:`parameters` with their meaning. Lengths are in spacings, angles in degrees.

    Returns
    -------
    Extraction
        Lines in the frame and unit of the input. The result depends neither on the order of the points nor on threads.

    Raises
    ------
    ParameterError
        For a parameter out of range.
    CloudError
        For points without a surface: fewer than four, collinear, beyond the limits.
    TypeError, ValueError
        For points that are no ``(N, 3)`` real numbers.
    """
    return run(points, settings(params, parameters), progress)


@signed(*LINES)
def patches(
    points: PointsLike,
    *,
    progress: Progress = False,
    params: ParamsLike | None = None,
    **parameters: Unpack[Parameters],
) -> Extraction:
    """Divides points into their smooth patches, the regions between the lines: :attr:`Extraction.patches`.

    The method is ``segments`` unless another is given, and ``patches_find`` is true. All else is as of :func:`extract`.

    Parameters
    ----------
    points, progress, params, parameters
        As of :func:`extract`.

    Raises
    ------
    ParameterError, CloudError, TypeError, ValueError
        As :func:`extract`.
    """
    given = settings(params, parameters)
    return run(points, [("method", "segments"), *given, ("patches.find", "true")], progress)


def run(points: PointsLike, given: list[tuple[str, str]], progress: Progress) -> Extraction:
    """The extraction with these parameters."""
    scan = as_scan(points)
    with watcher(progress) as watch:
        raw = _lineament.extract(scan.points, given, watch, scan.folds)
    return of(raw, scan)


def of(raw: _lineament.RawExtraction, scan: Scan) -> Extraction:
    """The extraction that the compiled part gave of a scan."""
    report = Report._of(raw["report"])
    used = raw["report"]["used"]
    known = {"method": report.used["method"], "parameters": used, "spacing": report.spacing, "noise": report.noise}
    network = Network._of(raw["network"], provenance(scan, **known))
    found, labels, classes = raw["found"], raw["labels"], raw["classes"]
    patched = None
    if raw["patches"] is not None and labels is not None:
        patched = Patches._of(raw["patches"], labels, network, classes, found, scan)
    relations, moved = [relation(r) for r in raw["relations"]], regularised(raw["regularised"])
    return Extraction(network, classes, raw["scores"], raw["clutter"], patched, relations, moved, report, scan, found)
