"""Networks against known lines."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lineament


def test_the_lines_of_a_cube_are_found_whole() -> None:
    found, truth = lineament.extract(lineament.sample("cube-15206")), lineament.truth("cube-15206")
    assert len(truth.curves) == 12 and sum(node.kind == "junction" for node in truth.nodes) == 8
    score = lineament.evaluate(found, truth)
    assert score.curves_found == (12, 12) and score.junctions_hit == (8, 8)
    assert score.at_1h.f1 > 0.98 and score.to_truth.mean < 0.3
    assert score.length_spacings == pytest.approx(sum(s.length for s in found.network) / found.report.spacing)


def test_a_network_is_its_own_truth_and_half_of_it_is_half_found() -> None:
    network = lineament.extract(lineament.sample("box")).network
    assert lineament.evaluate(network, network).at_1h == (1.0, 1.0, 1.0)
    lengths = sorted(strip.length for strip in network)
    half = network.where(lambda strip: strip.length <= lengths[5])
    score = lineament.evaluate(half, network)
    assert score.at_1h.precision == 1.0 and 0.2 < score.at_1h.recall < 0.6


def test_polylines_are_a_truth() -> None:
    line = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
    strips = lineament.extract(lineament.sample("box")).network
    score = lineament.evaluate(strips, [line, line + 100.0], spacing=0.1)
    assert score.curves_found.all == 2 and score.at_1h.recall < 0.6


@pytest.mark.parametrize("spacing", [0.0, -1.0, float("nan"), float("inf"), 1e-12])
def test_spacings_that_are_none_are_refused(spacing: float) -> None:
    network = lineament.extract(lineament.sample("cube-386")).network
    with pytest.raises(lineament.ParameterError, match="spacing"):
        lineament.evaluate(network, network, spacing=spacing)


def test_a_name_of_no_scan_is_answered_by_the_one_that_was_meant() -> None:
    with pytest.raises(ValueError, match="'bracket'"):
        lineament.truth("brackett")


def test_a_file_of_lines_is_a_truth_as_for_the_program(tmp_path: Path, program: Any) -> None:
    found, other = (lineament.extract(lineament.sample(name)) for name in ("box", "bracket"))
    found.write(tmp_path / "found.json")
    other.write(tmp_path / "other.json")
    other.write(tmp_path / "other.dxf")
    for name in ("other.json", "other.dxf"):
        score = lineament.evaluate(found, tmp_path / name)
        files = [tmp_path / "found.json", "--truth", tmp_path / name, "--spacing", repr(found.report.spacing)]
        assert program("evaluate", *files, "-o", tmp_path / "score.json").returncode == 0
        theirs = json.loads((tmp_path / "score.json").read_text())
        assert score.at_1h.recall == pytest.approx(theirs["at"][0]["recall"], abs=1e-12)
        assert score.junctions_hit.all == theirs["junctions_found"][1]
    assert lineament.evaluate(found, str(tmp_path / "found.json")).at_1h == (1.0, 1.0, 1.0)
    assert lineament.evaluate(found, found).at_1h == (1.0, 1.0, 1.0)
    with pytest.raises(lineament.InputError):
        lineament.evaluate(found, tmp_path / "none.json")
    with pytest.raises(TypeError, match="path of the file"):
        lineament.evaluate(found, {"schema": 1})  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]


def test_lines_count_by_their_length_and_not_by_their_vertices() -> None:
    network = lineament.extract(lineament.sample("cube-386")).network
    strips = [strip.polyline for strip in network]
    far = np.array([[9.0, 9.0, 9.0], [10.0, 9.0, 9.0]])
    dense = np.column_stack([np.linspace(9.0, 10.0, 1001), np.full((1001, 2), 9.0)])
    few, many = (lineament.evaluate(network, [*strips, line]).at_1h.recall for line in (far, dense))
    assert few == pytest.approx(many, abs=0.02) and few < 0.95
