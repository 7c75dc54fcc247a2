"""``write``: any result, in the format of the extension."""

from __future__ import annotations

from typing import Protocol

from lineament._network import Path


class Written(Protocol):
    """Whatever can be written: scans, extractions, networks, patches, classifications, sections."""

    def write(self, path: Path) -> None: ...


def write(path: Path, result: Written) -> None:
    """Writes a result to a file, whole or not at all, in the format of the extension: see its own ``write``."""
    result.write(path)
