"""``python -m lineament`` is the program ``lineament``."""

from __future__ import annotations

import sys

from lineament._lineament import main as _program


def main() -> int:
    """Runs the program with the words of the command line; the exit code."""
    return _program(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
