"""``render``: pictures of points and their lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from os import fspath
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from lineament import _lineament
from lineament._errors import OutputError
from lineament._network import Network, Path
from lineament._parameters import text
from lineament._points import PointsLike
from lineament._scan import as_scan

if TYPE_CHECKING:
    from lineament._extraction import Extraction

AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


@dataclass(frozen=True, eq=False)
class Picture:
    """A picture in memory. Notebooks show it."""

    pixels: npt.NDArray[np.uint8]
    """``(H, W, 3)`` red, green and blue (sRGB), rows from the top."""
    _files: Sequence[str] = field(default=(), repr=False)

    def write(self, path: Path) -> None:
        """Writes the picture as PNG, whole or not at all.

        Raises
        ------
        OutputError
            If the name does not end in ``.png``, or the file cannot be written.
        """
        if not fspath(path).lower().endswith(".png"):
            raise OutputError(f"{fspath(path)}: pictures are written as PNG only: end the name in `.png`")
        _lineament.write_picture(fspath(path), list(self._files), self.pixels)

    def _repr_png_(self) -> bytes:
        return _lineament.png(self.pixels)

    def __repr__(self) -> str:
        height, width = self.pixels.shape[:2]
        return f"Picture({width} x {height})"


def render(
    points: PointsLike,
    network: Network | Extraction | None = None,
    *,
    view: str | Sequence[float] = "auto",
    up: Literal["x", "y", "z"] | Sequence[float] = "z",
    size: tuple[int, int] = (1600, 1200),
    caption: bool = True,
) -> Picture:
    """Draws points, and lines over them, as ``lineament render``: creases red, borders blue, junctions black, corners green, ends
    pink; lines behind the surface faint and dashed. No graphics hardware is used.

    Parameters
    ----------
    points
        As of :func:`extract`.
    network
        The lines; without, the points alone are drawn.
    view
        Viewpoint: auto, top, bottom, front, back, left, right, iso, or a direction ``(x, y, z)`` towards the eye.
    up
        Axis or direction that points up in the picture.
    size
        Width and height in pixels, 16 to 16384.
    caption
        Whether a line of text explains the colours.

    Raises
    ------
    ParameterError
        For a size out of range, a view or direction that is none, lines far from the points.
    CloudError, TypeError, ValueError
        As :func:`extract`.
    """
    scan = as_scan(points)
    lines = network if network is None or isinstance(network, Network) else network.network
    width, height = size
    direction: Any = AXES.get(up, up) if isinstance(up, str) else [float(x) for x in up]
    if isinstance(direction, str):
        raise ValueError(f"up: '{direction}': expected x, y, z or a direction")
    options: _lineament.RenderOptions = {
        "view": view if isinstance(view, str) else text(list(view)),
        "up": direction,
        "width": width,
        "height": height,
        "caption": caption,
    }
    return Picture(_lineament.render(scan.points, lines, options), scan.files)
