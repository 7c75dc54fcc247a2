"""Networks as objects of other libraries, which are imported only here."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false
# pyright: reportMissingImports=false, reportMissingTypeStubs=false, reportMissingModuleSource=false

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from lineament._network import Network


def to_pyvista(network: Network) -> Any:
    import pyvista

    lines = [strip.polyline for strip in network]
    first = np.cumsum([0, *map(len, lines)])
    cells = [np.r_[len(line), np.arange(start, start + len(line))] for line, start in zip(lines, first, strict=False)]
    mesh = pyvista.PolyData()
    if lines:
        mesh = pyvista.PolyData(np.concatenate(lines), lines=np.concatenate(cells))
    for name, values in _columns(network).items():
        mesh.cell_data[name] = values
    return mesh


def to_trimesh(network: Network) -> Any:
    from trimesh.path import Path3D, entities

    # Declared in some versions without types.
    segment: Any = entities.Line
    lines = [strip.polyline for strip in network]
    first = np.cumsum([0, *map(len, lines)])
    chains = [
        segment(np.arange(start, start + len(line)), layer=strip.kind)
        for line, start, strip in zip(lines, first, network, strict=False)
    ]
    return Path3D(chains, vertices=np.concatenate(lines) if lines else np.empty((0, 3)), process=False)


def to_geodataframe(network: Network) -> Any:
    import geopandas
    from shapely.geometry import LineString

    lines = [LineString(strip.polyline) for strip in network]
    crs = network.provenance.crs_wkt or network.provenance.crs
    return geopandas.GeoDataFrame(_columns(network), geometry=lines, crs=crs)


def to_ezdxf(network: Network) -> Any:
    from ezdxf.filemanagement import new

    document = new("R2000")
    for layer, color in (("CREASE", 1), ("BORDER", 5)):
        document.layers.add(layer, color=color)
    space = document.modelspace()
    for strip in network:
        space.add_polyline3d(strip.points.tolist(), close=strip.closed, dxfattribs={"layer": strip.kind.upper()})
    return document


def _columns(network: Network) -> dict[str, Any]:
    """What is known of each strip, a column each; NaN where a number is not."""
    return {
        "kind": np.array([strip.kind for strip in network], dtype="U7"),
        "closed": np.array([strip.closed for strip in network], dtype=bool),
        "length": np.array([strip.length for strip in network], dtype=np.float64),
        "deviation": np.array([strip.deviation for strip in network], dtype=np.float64),
        "fold_deg": np.array([strip.fold_deg for strip in network], dtype=np.float64),
        "confidence": np.array([strip.confidence for strip in network], dtype=np.float64),
    }
