"""``render``: pictures of points and their lines."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Literal, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from lineament import _lineament
from lineament._errors import OutputError, ParameterError
from lineament._network import Network, Path
from lineament._points import PointsLike
from lineament._scan import Scan, as_scan

if TYPE_CHECKING:
    from lineament._extraction import Extraction

AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


class HasTriangles(Protocol):
    """Meshes of this package and of Open3D: ``vertices`` and ``triangles``."""

    @property
    def vertices(self) -> Any: ...
    @property
    def triangles(self) -> Any: ...


class HasFaces(Protocol):
    """Meshes of trimesh: ``vertices`` and ``faces``."""

    @property
    def vertices(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


Surface: TypeAlias = "Literal['points', 'none'] | str | PathLike[str] | HasTriangles | HasFaces"
"""What is seen and hides lines: the points, nothing, a mesh, or the file of one."""


@dataclass(frozen=True, eq=False)
class Picture:
    """A picture in memory. Notebooks show it."""

    pixels: npt.NDArray[np.uint8]
    """``(H, W, 3)`` red, green and blue (sRGB), rows from the top; ``(H, W, 4)`` with opacity on a transparent ground."""
    svg: str | None = field(default=None, repr=False)
    """A line drawing as the text of an SVG file; ``None`` of other pictures."""
    _files: Sequence[str] = field(default=(), repr=False)

    def write(self, path: Path) -> None:
        """Writes the picture as PNG, or a line drawing as SVG, whole or not at all.

        Raises
        ------
        OutputError
            If the name does not end in ``.png``, or ``.svg`` of a line drawing, or the file cannot be written.
        """
        name = fspath(path)
        if name.lower().endswith(".png"):
            return _lineament.write_picture(name, list(self._files), self.pixels)
        if not name.lower().endswith(".svg"):
            what = "pictures are written as PNG, and line drawings as SVG too: end the name in `.png` or `.svg`"
            raise OutputError(f"{name}: {what}")
        if self.svg is None:
            raise OutputError(f'{name}: SVG holds line drawings: render with style="lines"')
        _lineament.write_text(name, list(self._files), self.svg)

    def _repr_png_(self) -> bytes:
        return _lineament.png(self.pixels)

    def __repr__(self) -> str:
        height, width = self.pixels.shape[:2]
        return f"Picture({width} x {height})"


def render(
    points: PointsLike | None,
    network: Network | Extraction | None = None,
    *,
    view: str | Sequence[float] | Sequence[str] = "auto",
    up: Literal["x", "y", "z"] | Sequence[float] = "z",
    size: tuple[int, int] = (1600, 1200),
    style: Literal["shaded", "lines"] = "shaded",
    surface: Surface = "points",
    hidden: Literal["none", "dashed", "solid"] = "dashed",
    color: Literal["kind", "confidence", "ink"] = "kind",
    point_color: Literal["class", "score", "patch"] | None = None,
    background: Literal["white", "none"] = "white",
    scale_bar: bool = False,
    unit: str | None = None,
    caption: bool = True,
) -> Picture:
    """Draws points, and lines over them, as ``lineament render``: creases red, borders blue, rounded edges violet, junctions black, corners green, ends
    pink; lines behind the surface faint and dashed. No graphics hardware is used.

    Parameters
    ----------
    points
        As of :func:`extract`; ``None`` draws the lines alone.
    network
        The lines; without, the points alone are drawn.
    view
        Viewpoint: auto, top, bottom, front, back, left, right, iso, or a direction ``(x, y, z)`` towards the eye; several, as a
        sequence of names or with commas between them, stand on one sheet, of one scale.
    up
        Axis or direction that points up in the picture.
    size
        Width and height in pixels, 16 to 16384.
    style
        ``shaded``, the shaded surface and its lines, or ``lines``, a line drawing, which can be written as SVG too.
    surface
        What is seen and hides lines: ``points``, ``none``, a mesh (of :func:`mesh`, trimesh or Open3D), or the file of one.
    hidden
        Lines behind the surface: left out (``none``), ``dashed``, or drawn like the others (``solid``).
    color
        Colours of lines: their ``kind``, the ``confidence`` in them, or black ``ink``.
    point_color
        Colours of the points: their ``class``, ``score`` or ``patch``, which an :class:`Extraction` of them tells; white unless
        given.
    background
        ``white``, or ``none``, which is transparent.
    scale_bar
        Whether to draw a scale bar.
    unit
        Unit of the input that the scale bar names: mm, cm, m, in, ft or us-ft.
    caption
        Whether a line of text explains the colours.

    Raises
    ------
    ParameterError
        For a size out of range, a view or direction that is none, lines far from the points, options that exclude each other.
    InputError
        For a file that holds no mesh.
    CloudError, TypeError, ValueError
        As :func:`extract`.
    """
    scan = Scan(np.empty((0, 3))) if points is None else as_scan(points)
    lines = network if network is None or isinstance(network, Network) else network.network
    if points is None and lines is None:
        raise ParameterError("render: neither points nor lines are given")
    if unit is not None and not scale_bar:
        raise ParameterError("unit: there is no scale bar to name it: add scale_bar=True")
    mesh, files = _mesh(surface)
    options: _lineament.RenderOptions = {
        "view": _view(view),
        "up": _up(up),
        "width": size[0],
        "height": size[1],
        "caption": caption,
        "style": style,
        "hidden": hidden,
        "color": color,
        "background": background,
        "scale_bar": scale_bar,
        "unit": unit,
        "alone": points is None,
        "seen": isinstance(surface, str) and surface == "points",
    }
    tints = None
    if point_color is not None:
        _refuse_hidden(point_color, style, seen=options["seen"] and not options["alone"])
        tints = _tints(point_color, network, len(scan))
    return Picture(*_lineament.render(scan.points, lines, mesh, tints, options), [*scan.files, *files])


def _view(view: str | Sequence[float] | Sequence[str]) -> str:
    """One view or several as the program reads them."""
    return view if isinstance(view, str) else ",".join(v if isinstance(v, str) else repr(float(v)) for v in view)


def _up(up: str | Sequence[float]) -> Sequence[float]:
    if not isinstance(up, str):
        return [float(x) for x in up]
    if up not in AXES:
        raise ValueError(f"up: '{up}': expected x, y, z or a direction")
    return AXES[up]


def _mesh(surface: Surface) -> tuple[tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]] | None, list[str]]:
    """The mesh that is the surface, if one is, and the files that it was read from."""
    if isinstance(surface, (str, PathLike)):
        if surface in ("points", "none"):
            return None, []
        path = fspath(surface)
        read = _lineament.read_mesh(path)
        for warning in read["warnings"]:
            warnings.warn(warning, stacklevel=3)
        return (read["vertices"], read["triangles"]), [path]
    held: Any = surface
    faces = np.asarray(held.triangles if hasattr(held, "triangles") else held.faces)
    if faces.size and faces.min() < 0:
        raise ParameterError("surface: a triangle with a negative vertex")
    return (np.ascontiguousarray(held.vertices, np.float64), np.ascontiguousarray(faces, np.uint32)), []


def _refuse_hidden(name: str, style: str, *, seen: bool) -> None:
    """Refuses colours of points that are not drawn."""
    if style == "lines":
        raise ParameterError(f'point_color: `{name}`: a line drawing has no points: leave out style="lines"')
    if not seen:
        raise ParameterError(f"point_color: `{name}`: the points are not drawn: leave out surface")


def _tints(name: str, network: Network | Extraction | None, count: int) -> npt.NDArray[Any]:
    """A number of each point for its colour."""
    if network is None or isinstance(network, Network):
        raise ParameterError(f"point_color: `{name}`: it is found with the lines: pass what `extract` gave")
    patches = network.patches
    known: dict[str, npt.NDArray[Any] | None]
    known = {"class": network.classes, "score": network.scores, "patch": None if patches is None else patches.labels}
    if name not in known:
        raise ParameterError(f"point_color: `{name}`: expected one of {', '.join(known)}")
    values = known[name]
    if values is None:
        raise ParameterError("point_color: `patch`: patches were not looked for: extract with patches_find=True")
    if len(values) != count:
        raise ParameterError(f"point_color: `{name}`: {len(values)} of {count} points: the lines are of others")
    return values
