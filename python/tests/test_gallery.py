"""The gallery shows the pictures of the notebooks."""

from __future__ import annotations

import re
import struct
from pathlib import Path

import make_gallery
import pytest
from test_notebooks import ROOT

PAGE = ROOT / "docs" / "gallery.md"


def size(png: bytes) -> tuple[int, int]:
    """Width and height of a picture."""
    assert png.startswith(b"\x89PNG")
    width, height = struct.unpack(">II", png[16:24])
    return width, height


def test_its_pictures_are_those_of_the_notebooks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    made = {file: picture for name in make_gallery.NOTEBOOKS for file, picture in make_gallery.pictures(name).items()}
    kept = {path.name: path.read_bytes() for path in make_gallery.TARGET.iterdir()}
    assert set(made) == set(kept) and len(kept) > 3, "run make_gallery.py"
    for file, picture in made.items():
        height, width = picture.pixels.shape[:2]
        assert size(kept[file]) == (width, height), file


def test_the_page_shows_each_of_them() -> None:
    page = PAGE.read_text(encoding="utf-8")
    shown = re.findall(r"!\[[^\]]+\]\(([^)]+)\)", page)
    assert all((PAGE.parent / link).is_file() for link in shown)
    assert {Path(link).name for link in shown if link.startswith("gallery/")} == {p.name for p in make_gallery.TARGET.iterdir()}
