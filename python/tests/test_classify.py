"""Classes of points, as the program has them."""

from __future__ import annotations

from pathlib import Path
from typing import Any, get_args

import numpy as np
import pytest

import lineament
from lineament import _lineament
from lineament._classify import Detector


def test_the_detectors_are_those_of_the_program() -> None:
    assert list(get_args(Detector)) == _lineament.detectors()


@pytest.mark.parametrize("detector", [None, *get_args(Detector)])
def test_classes_are_those_of_the_program(detector: Any, bracket: Any, tmp_path: Path, program: Any) -> None:
    theirs = tmp_path / "theirs.npy"
    words = [] if detector is None else ["--detector", detector]
    assert program("classify", "--sample", "bracket", *words, "-o", theirs).returncode == 0
    found = lineament.classify(bracket, detector=detector)
    assert np.array_equal(found.classes, np.load(theirs)) and len(np.unique(found.classes)) > 1
    assert (found.network is None) == (detector is not None)
    assert np.nanmin(found.scores) >= 0.0 and np.nanmax(found.scores) <= 1.0


def test_points_are_written_with_their_attributes(tmp_path: Path, program: Any) -> None:
    rng = np.random.default_rng(1)
    points = lineament.sample("wedge")
    attributes: dict[str, Any] = {"intensity": rng.random(len(points)).astype(np.float32), "ring": np.arange(len(points))}
    lineament.classify(lineament.Scan(points, attributes)).write(tmp_path / "first.ply")
    ours, theirs = tmp_path / "ours.ply", tmp_path / "theirs.ply"
    lineament.classify(lineament.read(tmp_path / "first.ply")).write(ours)
    assert program("classify", tmp_path / "first.ply", "-o", theirs).returncode == 0
    assert ours.read_bytes() == theirs.read_bytes()
    back = lineament.read(ours)
    assert np.array_equal(back.points, points)
    assert np.array_equal(back.attributes["intensity"], attributes["intensity"])
    assert {"class", "score", "ring"} <= set(back.attributes)


def test_a_detector_of_no_name_is_refused(bracket: Any) -> None:
    with pytest.raises(lineament.ParameterError, match="surface-variation"):
        lineament.classify(bracket, detector="variation")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]
