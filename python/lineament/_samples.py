"""Generated scans with known lines, to try things out."""

from __future__ import annotations

import difflib

import numpy as np
import numpy.typing as npt

from lineament import _lineament


def samples() -> dict[str, str]:
    """Names and descriptions of the generated scans."""
    return dict(_lineament.samples())


def sample(name: str, seed: int = 1) -> npt.NDArray[np.float64]:
    """The points of a generated scan, such as ``bracket``, as an ``(N, 3)`` array: what ``--sample`` of the program reads.

    Raises
    ------
    ValueError
        If there is no scan of this name.
    """
    points = _lineament.sample(name, seed)
    if points is None:
        raise unknown(name)
    return points


def unknown(name: str) -> ValueError:
    """The exception for a name that no generated scan has."""
    near = difflib.get_close_matches(name, samples(), n=1)
    meant = f": did you mean '{near[0]}'?" if near else ""
    return ValueError(f"there is no sample '{name}'{meant}")
