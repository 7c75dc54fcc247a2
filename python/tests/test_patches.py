"""Patches, as the program has them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lineament


def test_a_box_has_six_planes(tmp_path: Path) -> None:
    points = lineament.sample("box")
    found = lineament.patches(points)
    patches = found.patches
    assert patches is not None and len(patches) == 6
    assert [patch.surface.kind for patch in patches] == ["plane"] * 6
    assert sorted(round(patch.area, 1) for patch in patches) == pytest.approx([6, 6, 8, 8, 12, 12], rel=0.05)
    assert len(patches.sides) == len(found.network) == 12
    for patch in patches:
        assert len(patch.neighbors) == 4 and len(patch.loops) == 1 and patch.loops[0].closed
        assert patch.surface.axis is not None and np.linalg.norm(patch.surface.axis) == pytest.approx(1.0)
    assert patches.labels.shape == (len(points),) and patches.labels.max() == 5
    assert lineament.extract(points).patches is None


def test_they_are_faces_in_step(tmp_path: Path) -> None:
    patches = lineament.patches(lineament.sample("cylinders")).patches
    assert patches is not None
    patches.write(tmp_path / "solid.step", unit="m")
    text = (tmp_path / "solid.step").read_text()
    assert text.count("=ADVANCED_FACE(") == len(patches) == 7
    assert "CLOSED_SHELL" in text and "SI_UNIT($,.METRE.)" in text


@pytest.mark.parametrize("extension", ["ply", "dxf"])
def test_they_are_written_as_by_the_program(extension: str, tmp_path: Path, program: Any) -> None:
    ours, theirs = tmp_path / f"ours.{extension}", tmp_path / f"theirs.{extension}"
    patches = lineament.patches(lineament.sample("cylinders")).patches
    assert patches is not None
    lineament.write(ours, patches)
    assert program("patches", "--sample", "cylinders", "-o", theirs).returncode == 0
    assert ours.read_bytes() == theirs.read_bytes()
