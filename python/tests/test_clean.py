"""Points on surfaces, as the program has them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lineament


@pytest.fixture(scope="module")
def scan(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A file of the bracket with returns from the air, and attributes."""
    path = tmp_path_factory.mktemp("scan") / "scan.ply"
    points = lineament.sample("bracket")
    low, high = points.min(axis=0), points.max(axis=0)
    air = np.random.default_rng(1).uniform(low, high + 2.0, (len(points) // 20, 3))
    points = np.vstack([points, air])
    attributes: dict[str, Any] = {"ring": np.arange(len(points)), "intensity": points[:, 0].astype(np.float32)}
    lineament.Scan(points, attributes).write(path)
    return path


@pytest.mark.parametrize("label", [False, True])
@pytest.mark.parametrize("extension", ["ply", "npy", "laz", "csv", "html"])
def test_points_are_written_as_by_the_program(extension: str, label: bool, scan: Path, tmp_path: Path, program: Any) -> None:
    ours, theirs = tmp_path / f"ours.{extension}", tmp_path / f"theirs.{extension}"
    done = program("clean", scan, *(["--label"] if label else []), "-o", theirs)
    assert done.returncode == 0, done.stderr
    found = lineament.clean(lineament.read(scan))
    assert len(found.clutter) > 50
    found.write(ours, label=label)
    assert ours.read_bytes() == theirs.read_bytes()


def test_surface_and_clutter_are_all_finite_points(scan: Path) -> None:
    read = lineament.read(scan)
    read.points[7, 1] = np.nan
    found = lineament.clean(read)
    both = np.sort(np.concatenate([found.surface, found.clutter]))
    assert np.array_equal(both, np.flatnonzero(np.isfinite(read.points).all(axis=1)))
    assert found.report.dropped == 1 and found.report.scattered + found.report.stray > 0
    assert np.array_equal(found.kept.attributes["ring"], found.surface)
    assert np.array_equal(found.points, found.kept.points)
    again = lineament.extract(found)
    assert len(again.network) > 20 and again.network.provenance.name == read.name
    assert np.array_equal(again.scan.attributes["ring"], found.surface)
