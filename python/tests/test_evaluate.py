"""Networks against known lines."""

from __future__ import annotations

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
