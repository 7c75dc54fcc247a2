"""Clouds of the folder of shared data beside the repository, if it is there: lines as the program has them, by every method."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal, get_args

import pytest

import lineament

SHARED = Path(__file__).parents[3] / "shared" / "data"
CLOUDS = (
    "cad/cube_386",
    "cad/fandisk_6475",
    "cad/hanger_4026",
    "cad/trimstar_5192",
    "cad/open_shell_15k_n25",
    "cad/blunt_steps_20k_n10",
    "cad/pipes_20k",
    "cad/neg_sphere_20k_n25",
    "brep/123091_2ebff124_3_n10",
    "brep/21242_6c2af7c2_7_c",
)
Method = Literal["penalty", "projection", "segments"]


@pytest.mark.parametrize("method", get_args(Method))
@pytest.mark.parametrize("cloud", CLOUDS)
def test_lines_of_files_are_those_of_the_program_to_the_bit(
    cloud: str, method: Method, tmp_path: Path, program: Any
) -> None:
    path = SHARED / cloud / "cloud.ply"
    if not path.exists():
        pytest.skip(f"{path} is not there")
    done = program("extract", path, "--method", method, "-o", tmp_path / "theirs.json")
    assert done.returncode == 0, done.stderr
    lineament.extract(lineament.read(path, hash=True), method=method).write(tmp_path / "ours.json")
    ours, theirs = ((tmp_path / name).read_text().splitlines() for name in ("ours.json", "theirs.json"))
    assert len(ours) > 20 and ours == theirs
