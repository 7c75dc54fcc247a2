"""Reports for browsers, as the program writes them."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import lineament
from lineament._write import Written


def patches(scan: lineament.Scan) -> Written:
    """The patches alone."""
    found = lineament.patches(scan).patches
    assert found is not None
    return found


MADE: list[tuple[list[str], Callable[[lineament.Scan], Written]]] = [
    (["extract"], lineament.extract),
    (["extract", "--method", "projection"], lambda scan: lineament.extract(scan, method="projection")),
    (["patches"], lineament.patches),
    (["patches"], patches),
    (["classify"], lineament.classify),
    (["classify", "--detector", "surface-variation"], lambda scan: lineament.classify(scan, detector="surface-variation")),
    (["section", "--axis", "z", "--count", "9", "--fit"], lambda scan: lineament.section(scan, axis="z", planes=9, fit=True)),
]


def data(page: Path) -> dict[str, Any]:
    """The data of a report."""
    found = re.search(r'<script[^>]*id="data"[^>]*>(.*?)</script>', page.read_text(encoding="utf-8"), re.DOTALL)
    assert found is not None
    held: dict[str, Any] = json.loads(found[1])
    return held


@pytest.fixture(scope="module")
def scan(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A file of a generated scan."""
    path = tmp_path_factory.mktemp("scan") / "cylinders.ply"
    lineament.Scan(lineament.sample("cylinders")).write(path)
    return path


@pytest.mark.parametrize(("words", "make"), MADE)
def test_they_are_those_of_the_program(
    words: list[str], make: Callable[[lineament.Scan], Written], scan: Path, tmp_path: Path, program: Any
) -> None:
    ours, theirs = tmp_path / "ours.html", tmp_path / "theirs.html"
    done = program(words[0], scan, *words[1:], "-o", theirs)
    assert done.returncode == 0, done.stderr
    read = lineament.read(scan)
    make(read).write(ours)
    assert data(ours)["points"]["count"] == len(read)
    assert ours.read_bytes() == theirs.read_bytes()


def test_a_report_holds_points_and_lines_and_a_network_its_lines_alone(
    bracket: Any, found: lineament.Extraction, tmp_path: Path
) -> None:
    whole, alone = tmp_path / "whole.html", tmp_path / "alone.html"
    found.write(whole)
    found.network.where(lambda strip: strip.closed).write(alone)
    both = data(whole), data(alone)
    assert [held["points"]["count"] for held in both] == [len(bracket), 0]
    assert len(both[0]["strips"]) == len(found.network)
    assert len(both[1]["strips"]) == sum(strip.closed for strip in found.network) > 0


def test_a_file_that_was_read_is_not_written_over(scan: Path, tmp_path: Path) -> None:
    page = tmp_path / "scan.html"
    page.write_bytes(scan.read_bytes())
    read = lineament.read(page)
    made: list[Written] = [lineament.extract(read), lineament.classify(read), lineament.clean(read), lineament.section(read)]
    for result in made:
        with pytest.raises(lineament.OutputError):
            result.write(page)
    assert page.read_bytes() == scan.read_bytes()
