"""``evaluate``: a network against a known truth."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, cast

import numpy as np
import numpy.typing as npt

from lineament import _lineament
from lineament._network import Network, Node, NodeKind, Path, Strip
from lineament._points import as_points

if TYPE_CHECKING:
    from lineament._extraction import Extraction


@dataclass(frozen=True, eq=False)
class TruthNode:
    """A point where curves of a truth meet or end."""

    position: npt.NDArray[np.float64]
    """``(3,)`` in the frame and unit of the points."""
    kind: NodeKind
    degree: int
    """The number of curve ends here."""


@dataclass(frozen=True, eq=False)
class TruthCurve:
    """One crease or border of a truth."""

    kind: Literal["crease", "border"]
    closed: bool
    """Whether it is a loop without nodes. The first point is then not repeated at the end."""
    start: int | None
    """Index of the node at the first point; ``None`` if there is none."""
    end: int | None
    """Index of the node at the last point; ``None`` if there is none."""
    points: npt.NDArray[np.float64]
    """``(M, 3)`` points of the curve, in order."""
    fold_deg: npt.NDArray[np.float64]
    """``(M,)`` angles between the faces, degrees; empty if they are not known, and for a border."""


@dataclass(frozen=True, eq=False)
class Truth:
    """Lines that are known."""

    nodes: list[TruthNode]
    curves: list[TruthCurve]
    weak_below_deg: float = 0.0
    """Fold, in degrees, below which a crease may be found or missed."""

    @classmethod
    def of(cls, lines: Network | Sequence[npt.ArrayLike]) -> Truth:
        """The truth of a network without its rounded edges, or of open ``(M, 3)`` polylines, which have no nodes."""
        if isinstance(lines, Network):
            # Rounded edges have nodes of their own, which come last.
            rounded = [strip for strip in lines.strips if strip.kind == "rounded"]
            own = [end for strip in rounded for end in (strip.start, strip.end) if end is not None]
            nodes = lines.nodes[: min(own, default=len(lines.nodes))]
            curves = [curve for strip in lines.strips if (curve := _curve(strip)) is not None]
            return cls([_node(node) for node in nodes], curves)
        none = np.empty(0)
        return cls([], [TruthCurve("crease", False, None, None, as_points(line), none) for line in lines])


def _node(node: Node) -> TruthNode:
    return TruthNode(node.position, node.kind, node.degree)


def _curve(strip: Strip) -> TruthCurve | None:
    """A strip as known line; ``None`` of a rounded edge."""
    kind = strip.kind
    if kind == "rounded":
        return None
    return TruthCurve(kind, strip.closed, strip.start, strip.end, strip.points, np.empty(0))


class Hits(NamedTuple):
    """Shares at one tolerance, 0 to 1; 0 if there is nothing to count."""

    precision: float
    """Share of the network's length that is near the truth."""
    recall: float
    """Share of the truth's length that is near the network."""
    f1: float
    """Harmonic mean of both."""


class Distances(NamedTuple):
    """Distances in spacings; NaN if there is nothing to measure."""

    mean: float
    max: float


class Found(NamedTuple):
    """What was found, and all there is."""

    found: int
    all: int


@dataclass(frozen=True)
class Score:
    """The score of a network."""

    at_1h: Hits
    """Within one spacing."""
    at_2h: Hits
    """Within two spacings."""
    to_truth: Distances
    """From the network to the truth."""
    from_truth: Distances
    """From the truth to the network."""
    loops: Found
    """Closed strips, and closed curves of the truth."""
    curves_found: Found
    """Curves of the truth with 90 % of their length within one spacing of the network, and all of at least 3 spacings."""
    junctions_hit: Found
    """Junctions of the truth within two spacings of a strip's end, and all junctions."""
    length_spacings: float
    """Length of all strips, in spacings."""


def truth(name: str, seed: int = 1) -> Truth:
    """The lines of a generated scan, known by construction.

    Raises
    ------
    ValueError
        If there is no scan of this name.
    """
    from lineament._samples import unknown

    raw = _lineament.truth(name, seed)
    if raw is None:
        raise unknown(name)
    nodes = [TruthNode(**node) for node in raw["nodes"]]
    return Truth(nodes, [TruthCurve(**curve) for curve in raw["curves"]], raw["weak_below_deg"])


def _known(truth: Any) -> Truth | str:
    """What the compiled part takes for known lines: a truth, or the path of a file."""
    if isinstance(truth, Truth):
        return truth
    if isinstance(truth, (str, PathLike)):
        return fspath(cast("Path", truth))
    if isinstance(truth, Mapping):
        raise TypeError("a mapping for the truth: give the path of the file, a Truth, a network or polylines")
    return Truth.of(getattr(truth, "network", truth))


def evaluate(
    found: Network | Extraction,
    truth: Truth | Network | Extraction | Sequence[npt.ArrayLike] | Path,
    *,
    spacing: float | None = None,
) -> Score:
    """Scores a network by its distances from known lines, in spacings.

    Both are cut into pieces of a fifth of a spacing along their length, and the distance of the end of each piece from the other is
    measured.

    Parameters
    ----------
    found
        The network.
    truth
        The lines that are known: :func:`truth` of a generated scan, a network, ``(M, 3)`` polylines, or the path of a file of lines: a
        network or truth in JSON, DXF, STEP, OBJ, or a mesh, whose edges count where its faces meet at more than 30 degrees.
    spacing
        Mean spacing of the points, in the unit of both; without, the one that the network was extracted with.

    Raises
    ------
    InputError
        For a file that cannot be read as lines.
    ParameterError
        For a spacing that is not above 0, or so small that the lines are longer than twenty million spacings.
    """
    network = found if isinstance(found, Network) else found.network
    known = _known(truth)
    raw = _lineament.evaluate(network, known, network.provenance.spacing if spacing is None else spacing)
    return Score(
        Hits(*raw["at_1h"]),
        Hits(*raw["at_2h"]),
        Distances(*raw["to_truth"]),
        Distances(*raw["from_truth"]),
        Found(*raw["loops"]),
        Found(*raw["curves_found"]),
        Found(*raw["junctions_hit"]),
        raw["length_spacings"],
    )
