"""The notebooks run, and show what they tell of."""

from __future__ import annotations

import ast
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
NOTEBOOKS = ROOT / "python" / "notebooks"
NAMES = ("part", "building", "figure", "comparison")


def cells(name: str) -> list[str]:
    """The cells of code of a notebook."""
    notebook = json.loads((NOTEBOOKS / f"{name}.ipynb").read_text(encoding="utf-8"))
    return ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]


def run(name: str) -> tuple[dict[str, Any], list[Any]]:
    """The names that a notebook leaves, and the values that its cells end with."""
    names: dict[str, Any] = {"__name__": "__main__"}
    shown: list[Any] = []
    for cell in cells(name):
        tree = ast.parse(cell)
        last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, name, "exec"), names)
        if isinstance(last, ast.Expr):
            shown.append(eval(compile(ast.Expression(last.value), name, "eval"), names))
    return names, shown


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Notebooks write into the folder that they run in."""
    monkeypatch.chdir(tmp_path)


def pictures(shown: list[Any]) -> int:
    """The number of pictures among values."""
    return sum(hasattr(value, "_repr_png_") and value._repr_png_().startswith(b"\x89PNG") for value in shown)


def test_there_are_no_others() -> None:
    assert sorted(path.stem for path in NOTEBOOKS.glob("*.ipynb")) == sorted(NAMES)


def test_the_part_has_its_bore_and_its_boss() -> None:
    names, shown = run("part")
    radii = sorted(circle.radius for circle in names["circles"])
    assert radii == pytest.approx([0.8, 0.8, 0.9, 0.9], abs=0.01)
    assert 0 < len(names["long"]) < len(names["found"].network)
    assert Path("bracket.dxf").stat().st_size > 1000
    assert pictures(shown) == 1 and "<svg" in names["found"]._repr_html_()


def test_the_building_has_its_plan() -> None:
    names, shown = run("building")
    assert len(names["cleaned"].clutter) > 0.5 * len(names["tree"])
    lengths = [strip.length for strip in names["found"].network if strip.kind == "crease"]
    assert max(lengths) == pytest.approx(8.0, abs=0.3)
    contours = names["plan"].sections[0].contours
    assert sum(contour.length for contour in contours) == pytest.approx(28.0 - 1.2, abs=0.6)
    assert Path("plan.dxf").stat().st_size > 1000 and pictures(shown) == 1


def test_the_figure_has_closed_edges() -> None:
    names, shown = run("figure")
    scores = names["scores"]
    assert all(score.at_1h.recall > 0.9 for score in scores.values())
    assert pictures(shown) == 2


def test_the_comparison_finds_the_borders() -> None:
    pytest.importorskip("open3d")
    names, _ = run("comparison")
    results = names["results"]
    assert all(min(results["lineament", noise]) > 0.9 for noise in (0.0, 0.1))
    assert results["Open3D", 0.0][1] > 0.5


@pytest.mark.parametrize("checker", [("mypy",), ("pyright", "--pythonpath", sys.executable)])
def test_checkers_of_types_are_content_with_them(checker: tuple[str, ...], tmp_path: Path) -> None:
    version = subprocess.run([sys.executable, "-m", checker[0], "--version"], capture_output=True, text=True, check=False)
    if version.returncode != 0:
        pytest.skip(f"{checker[0]} cannot be fetched: {version.stderr[-200:]}")
    for name in NAMES:
        code = "# pyright: strict, reportUnusedExpression=false\n" + "\n\n".join(cells(name))
        (tmp_path / f"{name}.py").write_text(code + "\n", encoding="utf-8")
    config = ["--config-file", str(ROOT / "pyproject.toml")] if checker[0] == "mypy" else []
    command = [sys.executable, "-m", *checker, *config, *(f"{tmp_path / name}.py" for name in NAMES)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
