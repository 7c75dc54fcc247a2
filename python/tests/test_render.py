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
