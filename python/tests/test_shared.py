"""Clouds of the folder of shared data beside the repository, if it is there: lines as the program has them, by every method."""

from __future__ import annotations

import json
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
    "brep/123091_2ebff124_3_n10",
    "brep/21242_6c2af7c2_7_c",
)
SPHERE = "cad/neg_sphere_20k_n25"
Method = Literal["auto", "penalty", "projection", "segments"]


def documents(cloud: str, method: Method, folder: Path, program: Any) -> tuple[str, str]:
    """The network of a cloud as the package and as the program write it."""
    path = SHARED / cloud / "cloud.ply"
    if not path.exists():
        pytest.skip(f"{path} is not there")
    done = program("extract", path, "--method", method, "-o", folder / "theirs.json")
    assert done.returncode == 0, done.stderr
    lineament.extract(lineament.read(path, hash=True), method=method).write(folder / "ours.json")
    ours, theirs = ((folder / name).read_text(encoding="utf-8") for name in ("ours.json", "theirs.json"))
    return ours, theirs


@pytest.mark.parametrize("method", get_args(Method))
@pytest.mark.parametrize("cloud", CLOUDS)
def test_lines_of_files_are_those_of_the_program_to_the_bit(
    cloud: str, method: Method, tmp_path: Path, program: Any
) -> None:
    ours, theirs = documents(cloud, method, tmp_path, program)
    assert len(ours.splitlines()) > 20 and ours == theirs


@pytest.mark.parametrize("method", get_args(Method))
def test_the_sphere_has_no_lines_as_by_the_program(method: Method, tmp_path: Path, program: Any) -> None:
    ours, theirs = documents(SPHERE, method, tmp_path, program)
    assert json.loads(ours)["strips"] == [] and ours == theirs
