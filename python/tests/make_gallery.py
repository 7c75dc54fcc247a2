"""Writes the pictures of ``docs/gallery.md``: those that the notebooks show.

``python python/tests/make_gallery.py`` after a change of notebooks or results, with the package installed anew; a test compares their
names and sizes.
"""

from __future__ import annotations

import os
import tempfile

import lineament
from test_notebooks import ROOT, run

TARGET = ROOT / "docs" / "gallery"
# Not `comparison`, which needs Open3D and prints figures.
NOTEBOOKS = ("part", "building", "figure")


def pictures(name: str) -> dict[str, lineament.Picture]:
    """The pictures that a notebook shows, by the names of their files."""
    _, shown = run(name)
    found = [value for value in shown if isinstance(value, lineament.Picture)]
    return {f"{name}-{number}.png": picture for number, picture in enumerate(found, 1)}


def main() -> None:
    """Writes them all."""
    TARGET.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)  # Notebooks write into the folder that they run in.
        for name in NOTEBOOKS:
            for file, picture in pictures(name).items():
                picture.write(TARGET / file)
        os.chdir(ROOT)


if __name__ == "__main__":
    main()
