"""Shared parts of the tests."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest

import lineament

Array = npt.NDArray[np.float64]


@pytest.fixture(scope="session")
def bracket() -> Array:
    """An L-bracket scanned from twelve sides."""
    return lineament.sample("bracket")


@pytest.fixture(scope="session")
def found(bracket: Array) -> lineament.Extraction:
    """Its lines."""
    return lineament.extract(bracket)


@pytest.fixture(scope="session")
def program() -> Callable[..., subprocess.CompletedProcess[str]]:
    """Runs the program: the one that ``LINEAMENT_PROGRAM`` names, or else that of the package."""
    named = os.environ.get("LINEAMENT_PROGRAM")
    command = [named] if named else [sys.executable, "-m", "lineament"]

    def run(*words: str | Path) -> subprocess.CompletedProcess[str]:
        return subprocess.run([*command, *map(str, words)], capture_output=True, text=True, check=False)

    return run
