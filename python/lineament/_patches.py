"""Patches: the smooth regions between the lines."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from os import fspath
from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from lineament import _lineament
from lineament._network import Network, Path
from lineament._scan import Scan

if TYPE_CHECKING:
    from lineament._lineament import RawPatch, RawPatches

SurfaceKind: TypeAlias = Literal["plane", "sphere", "cylinder", "cone", "torus"]


@dataclass(frozen=True, eq=False)
class Surface:
    """A surface fitted to a patch. Lengths and places are in the frame and unit of the input; what a kind does not have is
    ``None``."""

    kind: SurfaceKind
    point: npt.NDArray[np.float64]
    """``(3,)``: a point on a plane or on the axis of a cylinder; the centre of a sphere or torus; the apex of a cone."""
    axis: npt.NDArray[np.float64] | None
    """``(3,)`` unit vector: the outward normal of a plane; the axis of a cylinder, torus or cone, of this from its apex into it."""
    radius: float | None
    """Of a sphere or cylinder; the greater one of a torus."""
    minor_radius: float | None
    """The lesser one of a torus."""
    half_angle_deg: float | None
    """Half the opening angle of a cone, degrees."""
    residual: float
    """Root mean square distance of the points from it, leaving out those next to lines."""
    free_form: bool
    """Whether the residual exceeds noise and sampling: the patch has another shape or several."""


@dataclass(frozen=True)
class Loop:
    """A loop of strips round a patch."""

    strips: list[tuple[int, bool]]
    """Indices of strips in order, each with whether it is walked from its start to its end."""
    closed: bool
    outer: bool
    """Whether it is the outer loop; the others are holes."""


@dataclass(frozen=True, eq=False)
class Patch:
    """A smooth region of the surface."""

    points: int
    """The number of its points."""
    area: float
    """In the squared unit of the input."""
    neighbors: list[int]
    """Patches across the strips of its boundary, ascending."""
    loops: list[Loop]
    """Its boundary: the outer loop first, then the holes. Empty for a surface without boundary, such as a whole sphere."""
    surface: Surface
    """The surface that fits the points best."""


@dataclass(frozen=True)
class Sides:
    """The patches beside a strip."""

    left: int | None
    """The patch on the left when walking along the strip on the outside of the surface; ``None`` if the surface ends there."""
    right: int | None
    fold_deg: float | None
    """Mean angle between the outward normals of both patches along the strip, degrees; ``None`` at a border."""
    convex: bool | None
    """Whether the solid fills less than half of the space around the strip; ``None`` at a border."""


@dataclass(frozen=True, eq=False)
class Patches:
    """The patches between the lines of a network."""

    patches: list[Patch]
    sides: list[Sides]
    """One for each strip of the network."""
    labels: npt.NDArray[np.int32]
    """``(N,)`` patch of each point of the input, -1 for none."""
    _network: Network = field(repr=False)
    _classes: npt.NDArray[np.uint8] = field(repr=False)
    _found: _lineament.Found = field(repr=False)
    _scan: Scan = field(repr=False)

    @classmethod
    def _of(
        cls,
        raw: RawPatches,
        labels: npt.NDArray[np.int32],
        network: Network,
        classes: npt.NDArray[np.uint8],
        found: _lineament.Found,
        scan: Scan,
    ) -> Patches:
        patches = [_patch(patch) for patch in raw["patches"]]
        return cls(patches, [Sides(**sides) for sides in raw["sides"]], labels, network, classes, found, scan)

    def write(self, path: Path, *, unit: str | None = None) -> None:
        """Writes the patches, as ``lineament patches -o``: whole or not at all, in the format of the extension.

        Parameters
        ----------
        path
            ``.json`` and ``.dxf`` hold loops and surfaces, ``.step`` faces; ``.ply``, ``.las``, ``.npz`` and other formats of points hold the points
            with the number of their patch; ``.html`` is a report for browsers.
        unit
            Unit of the coordinates, which DXF and STEP state: mm, cm, m, in or ft. Nothing is scaled by it.

        Raises
        ------
        OutputError
            If no format has the extension, or the file cannot be written.
        """
        self._found.write_patches(
            fspath(path), self._scan, self._network.provenance, self.labels, self._classes, unit
        )

    def __iter__(self) -> Iterator[Patch]:
        return iter(self.patches)

    def __len__(self) -> int:
        return len(self.patches)

    def __repr__(self) -> str:
        return f"Patches({len(self.patches)} patches, {len(self.labels)} points)"


def _patch(raw: RawPatch) -> Patch:
    loops = [Loop(**loop) for loop in raw["loops"]]
    return Patch(raw["points"], raw["area"], raw["neighbors"], loops, Surface(**raw["surface"]))
