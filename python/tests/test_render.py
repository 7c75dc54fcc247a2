"""Pictures, as the program draws them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lineament


@pytest.mark.parametrize("lines", [True, False])
def test_pictures_are_those_of_the_program(lines: bool, bracket: Any, tmp_path: Path, program: Any) -> None:
    ours, theirs = tmp_path / "ours.png", tmp_path / "theirs.png"
    network = "computed" if lines else "none"
    words = ["--network", network, "--view", "1,2,3", "--size", "320x240", "--no-caption"]
    done = program("render", "--sample", "bracket", *words, "-o", theirs)
    assert done.returncode == 0, done.stderr
    found = lineament.extract(bracket) if lines else None
    picture = lineament.render(bracket, found, view=(1, 2, 3), size=(320, 240), caption=False)
    picture.write(ours)
    assert picture.pixels.shape == (240, 320, 3) and len(np.unique(picture.pixels)) > 20
    assert ours.read_bytes() == theirs.read_bytes() == picture._repr_png_()


SMALL = ["--size", "320x240", "--no-caption", "--sample", "cube-386"]


@pytest.mark.parametrize(
    ("words", "options"),
    [
        (["--style", "lines", "--hidden", "none", "--color", "ink", "--background", "none"],
         {"style": "lines", "hidden": "none", "color": "ink", "background": "none"}),
        (["--view", "front,1,2,3", "--scale-bar", "--unit", "mm", "--color", "confidence"],
         {"view": ["front", "1,2,3"], "scale_bar": True, "unit": "mm", "color": "confidence"}),
        (["--point-color", "class", "--view", "iso", "--hidden", "solid"],
         {"point_color": "class", "view": "iso", "hidden": "solid"}),
        (["--point-color", "patch", "--view", "iso"], {"point_color": "patch", "view": "iso"}),
        (["--surface", "none", "--up", "y"], {"surface": "none", "up": "y"}),
    ],
)  # fmt: skip
def test_every_option_is_that_of_the_program(words: list[str], options: Any, tmp_path: Path, program: Any) -> None:
    ours, theirs = tmp_path / "ours.png", tmp_path / "theirs.png"
    done = program("render", *SMALL, *words, "-o", theirs)
    assert done.returncode == 0, done.stderr
    points = lineament.sample("cube-386")
    found = lineament.extract(points, patches_find=options.get("point_color") == "patch")
    picture = lineament.render(points, found, size=(320, 240), caption=False, **options)
    picture.write(ours)
    assert picture.pixels.shape[2] == (4 if options.get("background") == "none" else 3)
    assert ours.read_bytes() == theirs.read_bytes()


def test_drawings_of_lines_over_a_mesh_are_those_of_the_program(tmp_path: Path, program: Any) -> None:
    points = lineament.sample("cube-386")
    mesh = lineament.mesh(points)
    lines, surface = tmp_path / "lines.json", tmp_path / "mesh.ply"
    mesh.extraction.write(lines)
    mesh.write(surface)
    theirs = tmp_path / "theirs.svg"
    done = program("render", lines, "--surface", surface, "--size", "320x240", "-o", theirs)
    assert done.returncode == 0, done.stderr
    for given in (mesh, surface):
        ours = tmp_path / "ours.svg"
        lineament.render(None, mesh.extraction, surface=given, style="lines", size=(320, 240)).write(ours)
        assert ours.read_bytes() == theirs.read_bytes()


def test_what_cannot_be_drawn_is_refused(bracket: Any, tmp_path: Path) -> None:
    with pytest.raises(lineament.ParameterError, match="16 to 16384"):
        lineament.render(bracket, size=(8, 8))
    with pytest.raises(lineament.ParameterError, match="view"):
        lineament.render(bracket, view="sideways")
    with pytest.raises(ValueError, match="up"):
        lineament.render(bracket, up="w")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]
    picture = lineament.render(bracket, size=(16, 16))
    with pytest.raises(lineament.OutputError, match="PNG"):
        picture.write(tmp_path / "picture.jpg")
    with pytest.raises(lineament.OutputError, match="style"):
        picture.write(tmp_path / "picture.svg")
    with pytest.raises(lineament.ParameterError, match="neither"):
        lineament.render(None)
    with pytest.raises(lineament.ParameterError, match="scale_bar"):
        lineament.render(bracket, unit="mm")
    with pytest.raises(lineament.ParameterError, match="expected one of none, dashed, solid"):
        lineament.render(bracket, hidden="faint")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]
    with pytest.raises(lineament.ParameterError, match="`extract` gave"):
        lineament.render(bracket, point_color="class")
    with pytest.raises(lineament.InputNotFoundError):
        lineament.render(bracket, surface=tmp_path / "none.stl")
