"""Networks as notebooks show them."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportMissingImports=false

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any

import numpy as np

from lineament import _lineament

if TYPE_CHECKING:
    from lineament._network import Network

MOST_BYTES = 2_000_000
"""Greatest size of a drawing in a notebook, which is saved with it."""

KINDS = {"crease": "creases", "border": "borders", "rounded": "rounded edges"}
"""Kinds of strips and their plurals."""


def drawing(network: Network, view: str) -> str:
    """A drawing of the network as SVG."""
    return _lineament.draw(network, network.provenance, view, None)


def as_html(network: Network) -> str:
    """Counts, and a drawing unless it is large."""
    lengths = {kind: sum(s.length for s in network if s.kind == kind) for kind in KINDS}
    counts = {kind: sum(s.kind == kind for s in network) for kind in lengths}
    told = ", ".join(f"{counts[k]} {KINDS[k]} of {lengths[k]:.6g} in all" for k in lengths if counts[k])
    nodes = f"{len(network.nodes)} nodes"
    name = html.escape(network.provenance.name)
    text = f"<p><b>Network</b> of {name}: {told or 'no lines'}; {nodes}</p>"
    if not network.strips:
        return text
    picture = drawing(network, "auto")
    start = picture.find("<svg")
    if len(picture) > MOST_BYTES:
        return f"{text}<p>The drawing is too large to show here: <code>plot()</code> or <code>write()</code></p>"
    return f'{text}<div style="max-width: 40em; background: white">{picture[start:]}</div>'


def plot(network: Network, axes: Any) -> Any:
    """Draws the network into axes of Matplotlib."""
    import matplotlib.pyplot as plt

    if axes is None:
        axes = plt.figure().add_subplot(projection="3d")
    for kind, color in (("crease", "C3"), ("border", "C0"), ("rounded", "C4")):
        for number, strip in enumerate(s for s in network if s.kind == kind):
            axes.plot(*strip.polyline.T, color=color, label=None if number else kind)
    if network.strips:
        extent = np.ptp(np.concatenate([strip.points for strip in network]), axis=0)
        axes.set_box_aspect(np.maximum(extent, 1e-3 * extent.max()))
        axes.legend()
    return axes
