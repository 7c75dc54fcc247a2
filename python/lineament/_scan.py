"""``read``: a file as points with their attributes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from os import PathLike, fspath
from pathlib import PurePath
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from lineament import _lineament
from lineament._points import Points, PointsLike, as_points

if TYPE_CHECKING:
    from lineament._network import Provenance

Path: TypeAlias = "str | PathLike[str]"


@dataclass(frozen=True, eq=False)
class Scan:
    """Points with their attributes, and where they come from. Every function that takes points takes it, and outputs carry its
    attributes and reference system."""

    points: Points
    """``(N, 3)`` float64, in the frame and unit of the file; rows that are not finite are in it."""
    attributes: dict[str, npt.NDArray[Any]] = field(default_factory=dict[str, "npt.NDArray[Any]"])
    """``(N,)`` further columns by their names, such as ``red`` or ``intensity``, in the types of the file."""
    name: str = "array"
    """The file, without folders."""
    format: str | None = None
    """The format that was recognised."""
    crs: str | None = None
    """The coordinate reference system: ``EPSG:`` and its code, or its name."""
    crs_wkt: str | None = None
    """Its definition in well-known text."""
    sha256: str | None = None
    """SHA-256 of the bytes of the file in hexadecimal; ``None`` of other points, or with ``hash=False``."""
    missing: str | None = None
    """What is missing of a file that ended early; only with ``salvage``."""
    warnings: list[str] = field(default_factory=list[str])
    """What makes it doubtful that the points are those that were meant, one sentence each."""
    ignored: list[str] = field(default_factory=list[str])
    """Parts of the file that are not in the points, one sentence each."""
    sampled: tuple[int, float] | None = None
    """The faces of a mesh on which the points were sampled, and the spacing of the points; ``None`` if they are those of the file."""
    folds: _lineament.Folds | None = field(default=None, repr=False)
    """The edges at which that mesh folds, which :func:`extract` takes for creases where points are near them."""
    files: list[str] = field(default_factory=list[str])
    """The files that were read, which no output overwrites."""
    las: _lineament.Las | None = field(default=None, repr=False)
    """How a LAS or LAZ file stored its coordinates, for outputs that are to be like it."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "points", as_points(self.points))

    @property
    def columns(self) -> list[tuple[str, npt.NDArray[Any]]]:
        """The attributes as pairs, as the compiled part reads them: in one piece, in the byte order of the machine."""
        return [(name, _whole(column)) for name, column in self.attributes.items()]

    def write(self, path: Path) -> None:
        """Writes the points with their attributes: whole or not at all, in the format of the extension.

        Parameters
        ----------
        path
            ``.npy`` (the positions alone), ``.npz``, ``.parquet``, ``.ply``, ``.las``, ``.laz``, ``.pcd``, ``.xyz``, ``.csv``, or
            ``.html`` (a report for browsers).

        Raises
        ------
        OutputError
            If no format has the extension, the file is one that was read, or it cannot be written.
        """
        _lineament.write_scan(fspath(path), self, None)

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return f"Scan({self.name}, {len(self.points)} points, {len(self.attributes)} attributes)"


def _whole(column: npt.NDArray[Any]) -> npt.NDArray[Any]:
    column = np.asarray(column)
    return np.require(column, column.dtype.newbyteorder("="), ["C_CONTIGUOUS", "ALIGNED"])


def as_scan(points: PointsLike) -> Scan:
    """The scan itself, the one that `clean` kept, or one of points of any kind."""
    held: Any = getattr(points, "kept", points)
    return held if isinstance(held, Scan) else Scan(as_points(points))


def provenance(scan: Scan, **known: Any) -> Provenance:
    """What outputs state of a scan, and what else is known."""
    from lineament._network import Provenance

    own: dict[str, Any] = {"name": scan.name, "sha256": scan.sha256, "points": len(scan), "crs": scan.crs, "crs_wkt": scan.crs_wkt}
    return Provenance(**own, **known)


def read(
    path: Path,
    *,
    bounds: Sequence[Sequence[float]] | None = None,
    every: int | None = None,
    voxel: float | None = None,
    classes: Sequence[int] = (),
    returns: Literal["first", "last", "only"] | None = None,
    scan: int | None = None,
    format: str | None = None,
    vertices: bool = False,
    samples: int | None = None,
    memory: int | None = None,
    salvage: bool = False,
    attributes: bool = True,
    hash: bool = True,
) -> Scan:
    """Reads the points of a file in any format of the program, recognised by its content first.

    Parameters
    ----------
    path
        PLY, tables (XYZ, TXT, CSV, PTS), LAS, LAZ, E57, PCD, PTX, OBJ, STL, OFF, glTF, NPY, NPZ, Parquet or ESRI grid.
    bounds
        Two corners of a box: only the points inside it, its faces included.
    every
        Only every n-th point.
    voxel
        Only one point of every cube with this edge, in the unit of the file.
    classes
        Only the points of these classes of a LAS file; none for all.
    returns
        Only these returns of each pulse of a LAS file.
    scan
        Only this scan of a file that holds several, counted from 1.
    format
        Takes the file for this format, whatever its content or name.
    vertices
        The vertices of a mesh alone; without, points sampled over its faces where the vertices are too few.
    samples
        So many points sampled over the faces of a mesh.
    memory
        Greatest number of bytes for the points of a compressed file; without, 64 MiB and eight times the file.
    salvage
        Reads the whole part of a file that ends early; ``missing`` tells the rest.
    attributes
        Keeps the columns beside the positions. Reading is faster without.
    hash
        Computes the SHA-256 of the file, which JSON outputs state. Reading is a little faster without.

    Raises
    ------
    InputError
        If the file cannot be opened, has no known format, breaks the rules of its format, or ends early.
    """
    options: _lineament.ReadOptions = {
        "bounds": None if bounds is None else [[float(x) for x in corner] for corner in bounds],
        "every": every,
        "voxel": voxel,
        "classes": list(classes),
        "returns": returns,
        "scan": scan,
        "format": format,
        "vertices": vertices,
        "samples": samples,
        "memory": memory,
        "salvage": salvage,
        "attributes": attributes,
        "hash": hash,
    }
    raw = _lineament.read(fspath(path), options)
    return Scan(
        points=raw["points"],
        attributes=dict(raw["attributes"]),
        name=PurePath(path).name,
        format=raw["format"],
        crs=raw["crs"] if raw["epsg"] is None else f"EPSG:{raw['epsg']}",
        crs_wkt=raw["crs_wkt"],
        sha256=raw["sha256"],
        sampled=raw["sampled"],
        folds=raw["folds"],
        missing=raw["missing"],
        warnings=raw["warnings"],
        ignored=raw["ignored"],
        files=[fspath(path), *map(str, raw["beside"])],
        las=raw["las"],
    )
