"""Sections, as the program has them."""

from __future__ import annotations

import inspect
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lineament

WORDS: list[tuple[dict[str, Any], list[str]]] = [
    ({}, []),
    ({"axis": "auto", "planes": 20, "fit": True}, ["--axis", "auto", "--count", "20", "--fit"]),
    ({"axis": [1, 0, 1], "planes": [0.5, 1.0]}, ["--axis", "1,0,1", "--at", "0.5,1.0"]),
    ({"planes": "adaptive:4", "outline": "hull"}, ["--adaptive", "4", "--outline", "hull"]),
]


@pytest.mark.parametrize(("given", "words"), WORDS)
def test_sections_are_those_of_the_program(
    given: dict[str, Any], words: list[str], bracket: Any, tmp_path: Path, program: Any
) -> None:
    theirs, ours = tmp_path / "theirs.json", tmp_path / "ours.json"
    done = program("section", "--sample", "bracket", *words, "-o", theirs)
    assert done.returncode == 0, done.stderr
    found = lineament.section(bracket, **given)
    assert sum(len(section.contours) for section in found) > 0
    found.write(ours)
    lines = [[line for line in path.read_text().splitlines() if '"input"' not in line] for path in (ours, theirs)]
    assert lines[0] == lines[1]


def test_a_tube_is_cut_into_rings() -> None:
    found = lineament.section(lineament.sample("tube"), planes=8, fit=True)
    assert found.axes.shape == (3, 3) and found.heights.shape == (8,)
    for section in found.sections[1:-1]:
        for contour in section.contours:
            assert contour.closed and [piece.kind for piece in contour.pieces] == ["circle"]
            assert contour.pieces[0].radius == pytest.approx(np.sqrt(abs(contour.area) / np.pi), rel=0.02)
    assert found.stack.runs and all(run.radius is not None for run in found.stack.runs)


def test_names_and_defaults_are_those_of_the_table() -> None:
    table = {p.short: p.default for p in lineament.parameters() if p.section == "section"}
    own = inspect.signature(lineament.section).parameters.values()
    assert {p.name: p.default for p in own if p.name not in {"points", "progress", "params"}} == table


def test_progress_grows_to_the_end(bracket: Any) -> None:
    told: list[float] = []
    lineament.section(bracket, planes=30, progress=lambda stage, share: told.append(share))
    assert told and max(told) == 1.0
