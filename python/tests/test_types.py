"""The types that the package declares: whole, and those of the compiled part."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def check(*words: str) -> None:
    done = subprocess.run([sys.executable, "-m", *words], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_mypy_is_content_with_package_and_tests() -> None:
    check("mypy")


def test_the_stubs_are_those_of_the_compiled_part() -> None:
    check("mypy.stubtest", "lineament._lineament", "--concise", "--mypy-config-file", "pyproject.toml")


def test_pyright_is_content_with_package_and_tests() -> None:
    version = subprocess.run([sys.executable, "-m", "pyright", "--version"], capture_output=True, text=True, check=False)
    if version.returncode != 0:
        pytest.skip(f"pyright cannot be fetched: {version.stderr[-200:]}")
    check("pyright", "--pythonpath", sys.executable)
