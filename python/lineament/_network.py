"""Feature networks: strips that meet in nodes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from lineament import _convert, _lineament, _show
from lineament._curves import BSpline, Curve, curve, spline

if TYPE_CHECKING:
    from lineament._lineament import RawNetwork, RawStrip

Path: TypeAlias = "str | PathLike[str]"
StripKind: TypeAlias = Literal["crease", "border", "rounded"]
NodeKind: TypeAlias = Literal["junction", "corner", "end", "apex"]


@dataclass(frozen=True, eq=False)
class Node:
    """A point where strips meet or end."""

    position: npt.NDArray[np.float64]
    """``(3,)`` in the frame and unit of the input."""
    kind: NodeKind
    """By the strips that meet here: ``junction`` three or more, ``corner`` two at an angle, ``end`` one, ``apex`` none."""
    degree: int
    """The number of strip ends here; a strip that starts and ends here counts twice."""
    source: int
    """The point of the cloud, as an index into the input."""


@dataclass(frozen=True, eq=False)
class Strip:
    """One feature line."""

    kind: StripKind
    """``crease`` where two faces meet, ``border`` where the surface ends, ``rounded`` where a round leads from face to face: then the
    line lies on the design edge, where the faces would meet."""
    closed: bool
    """Whether the line is a loop without nodes. The first point is then not repeated at the end."""
    start: int | None
    """Index of the node at the first point; ``None`` exactly when closed."""
    end: int | None
    """Index of the node at the last point; ``None`` exactly when closed."""
    points: npt.NDArray[np.float64]
    """``(M, 3)`` points on the curve, in order, in the frame and unit of the input; the first and the last lie on the nodes."""
    curve: BSpline | None
    """The fitted curve, from which ``points`` were taken; ``None`` for a polyline."""
    curves: list[Curve]
    """The strip in pieces of a type, end to end: lines, arcs, circles, ellipses and splines of least description length."""
    sources: npt.NDArray[np.uint32]
    """Points of the cloud along the strip, in order, as indices into the input."""
    length: float
    """Length of the polyline in the unit of the input, the closing segment of a loop included."""
    deviation: float
    """Root mean square distance of the source points from the curve, in the unit of the input."""
    fold_deg: float | None
    """Mean angle between the faces along a crease, degrees; ``None`` for borders and if it is not measured."""
    evidence: float | None
    """Mean evidence that the line is sharp rather than round, in variances of the noise; ``None`` if it is not measured."""
    confidence: float
    """Confidence in the line, from 0 (chance) to 1."""
    radius: float | None = None
    """Radius of the round of a rounded edge, in the unit of the input; ``None`` for other kinds."""
    radius_sigma: float | None = None
    """Its standard deviation."""

    @property
    def polyline(self) -> npt.NDArray[np.float64]:
        """``(M, 3)`` points of an open strip, ``(M + 1, 3)`` of a closed one with the first repeated at the end."""
        return np.concatenate([self.points, self.points[:1]]) if self.closed else self.points

    def __repr__(self) -> str:
        closed = "closed " if self.closed else ""
        return f"Strip({closed}{self.kind}, {len(self.points)} points, length {self.length:.6g})"


@dataclass(frozen=True)
class Provenance:
    """What outputs state beside the lines."""

    name: str = ""
    """The input, without folders."""
    sha256: str | None = None
    """SHA-256 of its bytes in hexadecimal."""
    points: int = 0
    """Its rows."""
    method: str = ""
    parameters: Sequence[tuple[str, str]] = ()
    """Keys and values of the parameters."""
    spacing: float = float("nan")
    """Mean spacing, unit of the input."""
    noise: float | None = None
    """Standard deviation of the noise across the surface, unit of the input."""
    crs: str | None = None
    """The coordinate reference system: ``EPSG:`` and its code, or its name."""
    crs_wkt: str | None = None
    """Its definition in well-known text."""


@dataclass(frozen=True, eq=False)
class Network:
    """A feature network: strips that run from node to node, and closed strips without any."""

    nodes: list[Node]
    strips: list[Strip]
    provenance: Provenance = field(default=Provenance(), repr=False)

    @classmethod
    def _of(cls, raw: RawNetwork, provenance: Provenance) -> Network:
        nodes = [Node(**node) for node in raw["nodes"]]
        return cls(nodes, [_strip(strip) for strip in raw["strips"]], provenance)

    def where(self, keep: Callable[[Strip], bool]) -> Network:
        """The network of the strips for which ``keep`` is true, such as ``network.where(lambda s: s.confidence > 0.5)``.

        Nodes in which none of them ends are left out; degrees and kinds of the others stay those of the whole network.
        """
        kept = [strip for strip in self.strips if keep(strip)]
        ends = sorted({end for strip in kept for end in (strip.start, strip.end) if end is not None})
        number: dict[int | None, int | None] = {node: i for i, node in enumerate(ends)}
        strips = [replace(s, start=number.get(s.start), end=number.get(s.end)) for s in kept]
        return replace(self, nodes=[self.nodes[node] for node in ends], strips=strips)

    def write(
        self,
        path: Path,
        *,
        view: str = "auto",
        millimetres: float | None = None,
        unit: str | None = None,
    ) -> None:
        """Writes the network in the format of the extension, whole or not at all.

        Parameters
        ----------
        path
            ``.json``, ``.dxf``, ``.step``, ``.svg``, ``.obj``, ``.ply``, ``.geojson``, ``.gpkg``, ``.glb``, ``.vtp``, ``.csv``, or
            ``.html`` (a report for browsers, of the lines without the points).
        view
            Viewpoint of drawings (SVG): auto, top, bottom, front, back, left, right, iso, or ``X,Y,Z``.
        millimetres
            Millimetres of a drawing for one unit of the input; without, it is fitted to 200 mm.
        unit
            Unit of the coordinates, which DXF and STEP state: mm, cm, m, in or ft. Nothing is scaled by it.

        Raises
        ------
        OutputError
            If no format has the extension, or the file cannot be written.
        """
        _lineament.write_network(fspath(path), [], self, self.provenance, (view, millimetres, unit))

    def to_pyvista(self) -> Any:
        """The strips as a ``pyvista.PolyData`` of lines, with kind, length and the like as cell data."""
        return _convert.to_pyvista(self)

    def to_trimesh(self) -> Any:
        """The strips as a ``trimesh.path.Path3D``, with the kind of each as its layer."""
        return _convert.to_trimesh(self)

    def to_geodataframe(self) -> Any:
        """The strips as a ``geopandas.GeoDataFrame`` of lines with height, in the reference system of the input."""
        return _convert.to_geodataframe(self)

    def to_ezdxf(self) -> Any:
        """The strips as 3D polylines of an ``ezdxf`` document, on the layers ``CREASE`` and ``BORDER``."""
        return _convert.to_ezdxf(self)

    def plot(self, axes: Any = None) -> Any:
        """Draws the strips into 3D axes of Matplotlib, new ones unless some are given, and returns these."""
        return _show.plot(self, axes)

    def _repr_html_(self) -> str:
        return _show.as_html(self)

    def __iter__(self) -> Iterator[Strip]:
        return iter(self.strips)

    def __len__(self) -> int:
        return len(self.strips)

    def __repr__(self) -> str:
        return f"Network({len(self.strips)} strips, {len(self.nodes)} nodes)"


def _strip(raw: RawStrip) -> Strip:
    fields: dict[str, Any] = {**raw, "curve": spline(raw["curve"]), "curves": [curve(c) for c in raw["curves"]]}
    return Strip(**fields)
