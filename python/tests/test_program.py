"""``python -m lineament`` is the program."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path


def run(*words: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-m", "lineament", *map(str, words)], capture_output=True, text=True, check=False)


def test_it_extracts_and_writes(tmp_path: Path) -> None:
    done = run("extract", "--sample", "cube-386", "-o", tmp_path / "cube.obj")
    assert done.returncode == 0 and "12 creases" in done.stderr
    assert (tmp_path / "cube.obj").exists()


def test_its_exit_codes_are_those_of_the_program(tmp_path: Path) -> None:
    assert run("--version").returncode == 0
    assert run("warp").returncode == 2
    assert run("extract", tmp_path / "none.ply").returncode == 3
    assert run("extract", "--sample", "cube-386", "--set", "neighbors.k=1").returncode == 4
