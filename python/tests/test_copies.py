"""Results go to other processes and into caches: copied and pickled, they write the same files."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lineament


def pickled(value: Any) -> Any:
    return pickle.loads(pickle.dumps(value))


COPIES: tuple[Callable[[Any], Any], ...] = (copy.copy, copy.deepcopy, pickled)


def same(a: Any, b: Any, folder: Path, extensions: tuple[str, ...]) -> None:
    """Both write the same bytes."""
    for extension in extensions:
        paths = [folder / f"{name}.{extension}" for name in "ab"]
        for value, path in zip((a, b), paths, strict=True):
            value.write(path)
        assert paths[0].stat().st_size > 100 and paths[0].read_bytes() == paths[1].read_bytes(), extension


@pytest.mark.parametrize("again", COPIES)
def test_lines_and_patches_are_the_same_again(again: Callable[[Any], Any], tmp_path: Path) -> None:
    found = lineament.patches(lineament.sample("cone"))
    other = again(found)
    assert other.report == found.report and np.array_equal(other.classes, found.classes)
    same(found, other, tmp_path, ("json", "dxf", "html"))
    assert found.patches is not None and len(found.patches) > 1
    same(found.patches, other.patches, tmp_path, ("json", "ply"))
    same(found.network, other.network, tmp_path, ("json",))


@pytest.mark.parametrize("again", COPIES)
def test_sections_are_the_same_again(again: Callable[[Any], Any], tmp_path: Path) -> None:
    sections = lineament.section(lineament.sample("tube"), planes=4, fit=True)
    same(sections, again(sections), tmp_path, ("json", "dxf", "html"))


@pytest.mark.parametrize("again", COPIES)
def test_other_results_are_the_same_again(again: Callable[[Any], Any], tmp_path: Path) -> None:
    points = lineament.sample("cube-386")
    same(lineament.classify(points), again(lineament.classify(points)), tmp_path, ("ply",))
    same(lineament.clean(points), again(lineament.clean(points)), tmp_path, ("las",))
    scan = lineament.read(tmp_path / "a.las")
    (tmp_path / "scans").mkdir()
    same(scan, again(scan), tmp_path / "scans", ("las",))
    picture = lineament.render(points, size=(100, 80))
    same(picture, again(picture), tmp_path, ("png",))


def lines(name: str) -> lineament.Extraction:
    return lineament.extract(lineament.sample(name))


def test_results_come_from_other_processes() -> None:
    names = ["cube-386", "wedge"]
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        for name, found in zip(names, pool.map(lines, names), strict=True):
            ours = lines(name).network
            assert [strip.length for strip in found.network] == [strip.length for strip in ours] != []


def test_bytes_of_another_version_are_refused() -> None:
    curve = lines("wedge").network.strips[0].curves[0]._typed
    (state,) = curve.__getnewargs__()
    assert type(curve)(state).__getnewargs__() == (state,)
    for wrong in (state[:-1], state.replace(lineament.__version__.encode(), b"9.9.9"), b""):
        with pytest.raises(lineament.ParameterError):
            type(curve)(wrong)
