"""Lines of generated scans, from Python and by the program."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest

import lineament

METHODS: tuple[Literal["auto", "penalty", "projection", "segments"], ...] = (
    "auto",
    "penalty",
    "projection",
    "segments",
)


def test_the_bracket_has_creases_that_meet_in_junctions(bracket: Any, found: lineament.Extraction) -> None:
    network = found.network
    assert sum(strip.kind == "crease" for strip in network) > 20
    for strip in network:
        assert strip.points.shape[1:] == (3,) and strip.points.dtype == np.float64
        assert strip.closed == (strip.start is None) == (strip.end is None)
        steps = np.linalg.norm(np.diff(strip.polyline, axis=0), axis=1)
        assert strip.length == pytest.approx(steps.sum(), rel=1e-12)
        if strip.start is not None and strip.end is not None:
            assert np.array_equal(strip.points[0], network.nodes[strip.start].position)
            assert np.array_equal(strip.points[-1], network.nodes[strip.end].position)
    assert found.classes.shape == found.scores.shape == (len(bracket),)
    assert set(np.unique(found.classes)) <= set(lineament.PointClass)
    assert found.report.read == len(bracket) and found.report.stages["detect"] > 0.0


def lines(path: Path) -> list[str]:
    """The lines of a document that do not name the input."""
    text = path.read_text(encoding="utf-8").splitlines()
    return [line for line in text if not line.startswith('"input"')]


def before_relations(text: list[str]) -> list[str]:
    """The lines of a document up to the relations."""
    return text[: next(k for k, line in enumerate(text) if line.startswith('"relations"'))]


FORMATS = ("json", "dxf", "step", "svg", "obj", "ply", "geojson", "gpkg", "glb", "vtp", "csv")
SCANS = ("cube-386", "random-cube", "wedge", "sheet")


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", SCANS)
def test_lines_are_those_of_the_program_to_the_bit(
    name: str, method: Literal["auto", "penalty", "projection", "segments"], tmp_path: Path, program: Any
) -> None:
    points = lineament.sample(name)
    theirs, ours = tmp_path / "theirs.json", tmp_path / "ours.json"
    done = program("extract", "--sample", name, "--method", method, "-o", theirs)
    assert done.returncode == 0, done.stderr
    found = lineament.extract(points, method=method)
    found.write(ours)
    assert len(lines(ours)) > 8 and lines(ours) == lines(theirs)
    if method != "segments":  # Its documents hold the patches as well.
        again = tmp_path / "again.json"
        found.network.write(again)
        # Relations, like patches, are the extraction's: a network by itself is written without.
        alone, whole = (before_relations(lines(document)) for document in (again, theirs))
        assert len(alone) > 8 and alone == whole
        assert '"relations": []' in lines(again)


def test_the_order_and_the_memory_of_points_do_not_matter() -> None:
    points = lineament.sample("wedge")
    whole = lineament.extract(points).network
    wide = np.zeros((len(points), 5))
    wide[:, :3] = points
    assert len(whole) > 3
    for same in (wide, np.asfortranarray(points), points[::-1], points.tolist()):
        other = lineament.extract(same).network
        assert all(np.array_equal(a.points, b.points) for a, b in zip(whole, other, strict=True))


def test_points_of_single_precision_are_taken_as_they_are() -> None:
    single = lineament.sample("wedge").astype(np.float32)
    a, b = lineament.extract(single).network, lineament.extract(single.astype(np.float64)).network
    assert len(a) > 3 and all(np.array_equal(x.points, y.points) for x, y in zip(a, b, strict=True))


def test_strips_are_typed_curves_end_to_end() -> None:
    network = lineament.extract(lineament.sample("tube")).network
    kinds = {curve.kind for strip in network for curve in strip.curves}
    assert "circle" in kinds
    for strip in network:
        for curve in strip.curves:
            assert (curve.radius is None) == (curve.kind in {"line", "b-spline"})
            if curve.radius is not None and curve.covariance is not None:
                assert curve.radius_sigma == pytest.approx(np.sqrt(curve.covariance[3, 3]))
        assert all(np.array_equal(a.end, b.start) for a, b in itertools.pairwise(strip.curves))


def test_a_part_of_a_network_is_a_network(found: lineament.Extraction, tmp_path: Path) -> None:
    network = found.network
    long = network.where(lambda strip: strip.length > 5.0)
    assert 0 < len(long) < len(network)
    for strip in long:
        if strip.start is not None:
            assert np.array_equal(strip.points[0], long.nodes[strip.start].position)
    long.write(tmp_path / "long.dxf")
    assert (tmp_path / "long.dxf").read_text().count("AcDbLine\n") > 0


def test_files_for_cad_state_the_unit(found: lineament.Extraction, tmp_path: Path) -> None:
    found.write(tmp_path / "lines.dxf", unit="in")
    assert "$INSUNITS\n70\n1\n" in (tmp_path / "lines.dxf").read_text()
    found.network.write(tmp_path / "lines.step", unit="m")
    assert "SI_UNIT($,.METRE.)" in (tmp_path / "lines.step").read_text()
    with pytest.raises(lineament.ParameterError, match="mile"):
        found.write(tmp_path / "lines.dxf", unit="mile")


def test_every_format_is_that_of_the_program(found: lineament.Extraction, tmp_path: Path, program: Any) -> None:
    theirs = [tmp_path / f"theirs.{extension}" for extension in FORMATS]
    words = [word for path in theirs for word in ("-o", path)]
    assert program("extract", "--sample", "bracket", *words).returncode == 0
    for path in theirs:
        ours = tmp_path / f"ours{path.suffix}"
        found.write(ours)
        if path.suffix in {".json", ".gpkg"}:  # They hold the name, and one of them its length as well.
            assert ours.stat().st_size > 1000
        else:
            assert ours.read_bytes().replace(b"array", b"sample bracket, seed 1") == path.read_bytes(), path.suffix
