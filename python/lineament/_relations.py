"""Relations between the typed curves of lines, and what their imposition moved."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from lineament._lineament import RawRegularised, RawRelation

RelationKind: TypeAlias = Literal[
    "parallel", "perpendicular", "coplanar", "coaxial", "concentric", "equal-radius", "tangent", "symmetric"
]


@dataclass(frozen=True, eq=False)
class Relation:
    """A relation between curves of a network; an arc or circle has the direction of its axis."""

    kind: RelationKind
    members: list[tuple[int, int]]
    """The curves: index of the strip, index in its ``curves``."""
    others: list[tuple[int, int]]
    """Of a right angle the curves of the other direction, of a mirror the image of each member; else empty."""
    likelihood: float
    """Probability of the relation against chance, 0 to 1; of a mirror the share of the length that has its image."""
    deviation: float | None
    """Root mean square deviation of the fits from it, before it was imposed, a length in the unit of the input; ``None`` of angles."""
    deviation_deg: float | None
    """The same of parallels and right angles, degrees."""
    direction: npt.NDArray[np.float64] | None
    """``(3,)`` unit vector: common direction, normal of the plane or mirror, axis."""
    point: npt.NDArray[np.float64] | None
    """``(3,)`` point of the plane, mirror or axis; the common centre."""
    radius: float | None
    """The common radius."""
    imposed: bool
    """Whether curves were moved so that it holds exactly (``relations_regularise=True``); the rest is then as after the move."""

    def __repr__(self) -> str:
        others = f" and {len(self.others)}" if self.others else ""
        return f"Relation({self.kind}, {len(self.members)}{others} curves, likelihood {self.likelihood:.3g})"


@dataclass(frozen=True, eq=False)
class Regularised:
    """How far the imposition of relations has moved nodes and curves, in the unit of the input."""

    nodes: npt.NDArray[np.float64]
    """``(N,)`` of each node."""
    curves: list[npt.NDArray[np.float64]]
    """``(C,)`` of each curve of each strip: the greatest distance of its ends and, of an arc or circle, of its centre and radius."""
    released: list[tuple[int, int]]
    """Curves left out of a relation, as it contradicted others or would have moved them by more than their points allow."""

    @property
    def greatest(self) -> float:
        """The greatest of all."""
        return float(np.max(np.concatenate([self.nodes, *self.curves]), initial=0.0))


def relation(raw: RawRelation) -> Relation:
    """A relation of the compiled part."""
    return Relation(**raw)


def regularised(raw: RawRegularised | None) -> Regularised | None:
    """What was moved, of the compiled part."""
    return None if raw is None else Regularised(**raw)
