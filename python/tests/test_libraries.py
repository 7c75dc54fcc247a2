"""Objects of other libraries, as points and as results. Each test is skipped where its library is not installed: none is needed."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false
# pyright: reportMissingImports=false, reportMissingTypeStubs=false, reportMissingModuleSource=false

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lineament
from lineament._points import as_points

ROWS = np.random.default_rng(1).random((20, 3))


@pytest.fixture(scope="module")
def network() -> lineament.Network:
    """Creases between nodes and closed borders."""
    networks = [lineament.extract(lineament.sample(name)).network for name in ("wedge", "tube")]
    assert any(strip.closed for strip in networks[1])
    return lineament.Network([], [strip for network in networks for strip in network], networks[0].provenance)


def test_clouds_of_pandas() -> None:
    pandas: Any = pytest.importorskip("pandas")
    frame = pandas.DataFrame(ROWS, columns=["x", "y", "z"])
    frame.insert(0, "intensity", 1.0)
    assert np.array_equal(as_points(frame), ROWS)


def test_clouds_of_open3d() -> None:
    open3d: Any = pytest.importorskip("open3d")
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(ROWS))
    assert np.array_equal(as_points(cloud), ROWS)


def test_clouds_of_trimesh() -> None:
    trimesh: Any = pytest.importorskip("trimesh")
    assert np.array_equal(as_points(trimesh.PointCloud(ROWS)), ROWS)
    assert as_points(trimesh.creation.box()).shape == (8, 3)


def test_clouds_of_pyvista() -> None:
    pyvista: Any = pytest.importorskip("pyvista")
    assert np.array_equal(as_points(pyvista.PolyData(ROWS)), ROWS)


def test_clouds_of_laspy() -> None:
    laspy: Any = pytest.importorskip("laspy")
    las = laspy.create()
    las.header.scales = [1e-6, 1e-6, 1e-6]
    las.x, las.y, las.z = ROWS.T
    assert np.abs(as_points(las) - ROWS).max() < 1e-6


def test_lines_for_pyvista(network: lineament.Network) -> None:
    pytest.importorskip("pyvista")
    mesh = network.to_pyvista()
    assert mesh.n_cells == len(network) and mesh.length > 0.0
    assert list(mesh.cell_data["kind"]) == [strip.kind for strip in network]
    lengths = mesh.compute_cell_sizes()["Length"]
    assert np.allclose(lengths, [strip.length for strip in network])


def test_lines_for_trimesh(network: lineament.Network) -> None:
    pytest.importorskip("trimesh")
    path = network.to_trimesh()
    assert len(path.entities) == len(network)
    assert path.length == pytest.approx(sum(strip.length for strip in network))


def test_lines_for_geopandas(network: lineament.Network) -> None:
    pytest.importorskip("geopandas")
    frame = network.to_geodataframe()
    assert list(frame.kind) == [strip.kind for strip in network] and frame.geometry.has_z.all()
    assert np.array_equal(np.array(frame.geometry[0].coords), network.strips[0].polyline)


def test_lines_for_ezdxf(network: lineament.Network, tmp_path: Path) -> None:
    ezdxf: Any = pytest.importorskip("ezdxf")
    network.to_ezdxf().saveas(tmp_path / "lines.dxf")
    document = ezdxf.readfile(tmp_path / "lines.dxf")
    lines = list(document.modelspace().query("POLYLINE"))
    assert not document.audit().has_errors and len(lines) == len(network)
    assert [line.is_closed for line in lines] == [strip.closed for strip in network]


def test_lines_in_axes_of_matplotlib(network: lineament.Network) -> None:
    matplotlib: Any = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    axes = network.plot()
    assert len(axes.lines) == len(network)


def test_no_lines_for_any() -> None:
    none = lineament.Network([], [])
    for library, hand in (("pyvista", none.to_pyvista), ("trimesh", none.to_trimesh), ("geopandas", none.to_geodataframe), ("ezdxf", none.to_ezdxf)):
        try:
            __import__(library)
        except ImportError:
            continue
        assert hand() is not None


def test_notebooks_show_a_drawing(network: lineament.Network, found: lineament.Extraction) -> None:
    shown = network._repr_html_()
    assert "creases" in shown and "<svg" in shown and "<script" not in shown
    assert "<svg" in found._repr_html_()
    assert "no lines" in lineament.Network([], [])._repr_html_()
