"""What lines are for: graphs, enriched points and meshes, as the program has them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lineament


@pytest.fixture(scope="module")
def scan(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A file of a small cube with attributes, normals among them."""
    path = tmp_path_factory.mktemp("scan") / "cube.ply"
    points = lineament.sample("cube-386")
    normals = np.sign(points - points.mean(axis=0)).astype(np.float32)
    attributes: dict[str, Any] = {"row": np.arange(len(points), dtype=np.int32)}
    attributes.update(zip(("nx", "ny", "nz"), normals.T))
    lineament.Scan(points, attributes).write(path)
    return path


def same(program: Any, words: list[Any], ours: Path, theirs: Path) -> None:
    """Whether the program writes the same bytes."""
    done = program(*words, "-o", theirs)
    assert done.returncode == 0, done.stderr
    assert ours.read_bytes() == theirs.read_bytes()


@pytest.mark.parametrize(
    ("extension", "kind", "all"), [("ply", "riemannian", True), ("json", "delaunay", False), ("npz", "riemannian", False)]
)
def test_graphs_are_those_of_the_program(
    extension: str, kind: Any, all: bool, scan: Path, tmp_path: Path, program: Any
) -> None:
    found = lineament.graph(lineament.read(scan, hash=True), graph=kind)
    ours, theirs = tmp_path / f"ours.{extension}", tmp_path / f"theirs.{extension}"
    found.write(ours, all=all)
    same(program, ["graph", scan, "--graph", kind, *(["--all"] if all else [])], ours, theirs)
    assert found.edges.dtype == np.uint32 and found.edges.shape[1] == found.cut.shape[1] == 2
    assert len(found.edges) > len(found.cut) > 0 and found.edges.max() < len(found.extraction.scan)
    assert len(found.extraction.network) == 12


@pytest.mark.parametrize(("extension", "added"), [("ply", False), ("csv", True), ("html", False)])
def test_enriched_points_are_those_of_the_program(
    extension: str, added: bool, scan: Path, tmp_path: Path, program: Any
) -> None:
    found = lineament.enrich(lineament.read(scan), step=0.5)
    ours, theirs = tmp_path / f"ours.{extension}", tmp_path / f"theirs.{extension}"
    found.write(ours, added=added)
    same(program, ["enrich", scan, "--step", "0.5", *(["--added"] if added else [])], ours, theirs)
    assert len(found) == len(found.points) == len(found.classes) == len(found.extraction.scan) + len(found.added)
    assert np.count_nonzero(found.kinds == lineament.PointClass.CORNER) == 8
    # What is enriched is points again, and those on lines are on them.
    near = np.linalg.norm(found.added - found.extraction.scan.points[found.sources], axis=1)
    assert near.max() < found.extraction.report.spacing
    assert len(lineament.extract(found).network) >= 12


@pytest.mark.parametrize(("extension", "enrich"), [("stl", True), ("obj", False)])
def test_meshes_are_those_of_the_program(extension: str, enrich: bool, scan: Path, tmp_path: Path, program: Any) -> None:
    found = lineament.mesh(lineament.read(scan), enrich=enrich)
    ours, theirs = tmp_path / f"ours.{extension}", tmp_path / f"theirs.{extension}"
    found.write(ours)
    same(program, ["mesh", scan, *([] if enrich else ["--no-enrich"])], ours, theirs)
    assert found.triangles.max() < len(found.vertices) == len(found.kinds)
    a, b, c = (found.vertices[found.triangles[:, k]] - found.vertices.mean(axis=0) for k in range(3))
    volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
    box = np.ptp(found.extraction.scan.points, axis=0).prod()
    assert 0.97 * box < volume < 1.03 * box and bool((found.kinds > 0).any()) is enrich


def test_what_cannot_be_applied_is_refused(scan: Path, tmp_path: Path) -> None:
    points = lineament.read(scan)
    with pytest.raises(lineament.ParameterError, match="step"):
        lineament.enrich(points, step=0.0)
    with pytest.raises(lineament.ParameterError, match="enrich"):
        lineament.mesh(points, step=1.0, enrich=False)
    with pytest.raises(lineament.ParameterError, match="riemannian or delaunay"):
        lineament.graph(points, graph="gabriel")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]
    with pytest.raises(lineament.OutputError):
        lineament.mesh(points).write(tmp_path / "mesh.xyz")
