"""Files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lineament


def test_what_was_written_is_read(tmp_path: Path) -> None:
    points = np.random.default_rng(1).random((50, 3)) * 1e5
    np.savetxt(tmp_path / "cloud.xyz", points, fmt="%.17g")
    scan = lineament.read(tmp_path / "cloud.xyz", hash=True)
    assert np.array_equal(scan.points, points) and scan.name == "cloud.xyz" and len(scan.sha256 or "") == 64
    assert len(lineament.read(tmp_path / "cloud.xyz", every=10)) == 5
    box = lineament.read(str(tmp_path / "cloud.xyz"), bounds=[[0, 0, 0], [5e4, 5e4, 1e5]])
    assert np.array_equal(box.points, points[(points[:, :2] <= 5e4).all(axis=1)])


def test_columns_of_a_table_are_written_whatever_their_memory(tmp_path: Path) -> None:
    table = np.random.default_rng(1).random((50, 6)).astype(np.float32)
    attributes: dict[str, Any] = {"intensity": table[:, 3], "ring": np.arange(100, dtype=">i2")[::2]}
    points: Any = table[:, :3]
    lineament.Scan(points, attributes).write(tmp_path / "table.ply")
    back = lineament.read(tmp_path / "table.ply")
    assert np.array_equal(back.points, points)
    assert all(np.array_equal(back.attributes[name], column) for name, column in attributes.items())


def test_lines_of_a_file_are_the_document_of_the_program(tmp_path: Path, program: Any) -> None:
    np.save(tmp_path / "bracket.npy", lineament.sample("bracket"))
    scan = lineament.read(tmp_path / "bracket.npy", attributes=False)
    lineament.extract(scan).write(tmp_path / "ours.json")
    assert program("extract", tmp_path / "bracket.npy", "-o", tmp_path / "theirs.json").returncode == 0
    ours, theirs = ((tmp_path / name).read_text().splitlines() for name in ("ours.json", "theirs.json"))
    assert len(ours) > 20 and ours == theirs


def test_the_hash_of_a_file_is_left_out_on_demand(tmp_path: Path) -> None:
    np.savetxt(tmp_path / "cloud.xyz", np.eye(3))
    assert lineament.read(tmp_path / "cloud.xyz", hash=False).sha256 is None
    assert len(lineament.read(tmp_path / "cloud.xyz").sha256 or "") == 64


def test_a_file_that_cannot_be_read_is_told_in_the_words_of_the_program(tmp_path: Path, program: Any) -> None:
    (tmp_path / "bad.ply").write_text("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n1\n")
    with pytest.raises(lineament.InputError) as told:
        lineament.read(tmp_path / "bad.ply")
    assert str(told.value) in program("info", tmp_path / "bad.ply").stderr
    with pytest.raises(FileNotFoundError) as missing:
        lineament.read(tmp_path / "none.ply")
    assert str(missing.value) in program("info", tmp_path / "none.ply").stderr


def test_the_file_that_was_read_is_not_overwritten(tmp_path: Path) -> None:
    lineament.classify(lineament.sample("wedge")).write(tmp_path / "wedge.ply")
    scan = lineament.read(tmp_path / "wedge.ply")
    with pytest.raises(lineament.OutputError, match="never overwritten"):
        lineament.classify(scan).write(tmp_path / "wedge.ply")
    with pytest.raises(lineament.OutputError, match="never overwritten"):
        lineament.extract(scan).write(tmp_path / "wedge.ply")
