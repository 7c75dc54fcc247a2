"""Points of all kinds, and those that are none."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import lineament
from lineament._points import as_points

ROWS = np.arange(12.0).reshape(4, 3)


def test_an_array_of_float64_is_not_copied() -> None:
    assert np.shares_memory(as_points(ROWS), ROWS)
    assert not np.shares_memory(as_points(ROWS[:, ::-1]), ROWS)
    shifted = np.frombuffer(b"-" + ROWS.tobytes(), np.float64, offset=1).reshape(ROWS.shape)
    assert not shifted.flags.aligned and as_points(shifted).flags.aligned


def test_masked_rows_are_not_finite() -> None:
    masked = np.ma.masked_array(ROWS, mask=ROWS == 4.0)
    assert np.array_equal(np.isnan(as_points(masked)), ROWS == 4.0)


class Records:
    """LAS data: scaled coordinates beside records of integers."""

    x, y, z = ROWS.T
    points = np.zeros(4, dtype=[("X", "i4"), ("Y", "i4")])


@pytest.mark.parametrize(
    "points",
    [
        ROWS.tolist(),
        np.hstack([ROWS, ROWS]),
        ROWS.astype(np.int16),
        ROWS.astype(">f8"),
        SimpleNamespace(points=ROWS),
        SimpleNamespace(vertices=ROWS),
        SimpleNamespace(points=lambda: None, x=ROWS[:, 0], y=ROWS[:, 1], z=ROWS[:, 2]),
        Records(),
        {"x": ROWS[:, 0], "y": ROWS[:, 1], "z": ROWS[:, 2], "intensity": ROWS[:, 0]},
        {"X": ROWS[:, 0], "Y": ROWS[:, 1], "Z": ROWS[:, 2]},
    ],
)
def test_points_are_found_in_objects_of_other_libraries(points: Any) -> None:
    assert np.array_equal(as_points(points), ROWS)


def test_what_is_no_points_is_refused_with_its_shape_and_type() -> None:
    with pytest.raises(ValueError, match=r"\(4, 2\)"):
        lineament.extract(ROWS[:, :2])
    for lying in (np.zeros((3, 500)), np.zeros((3, 20), np.float32)):
        with pytest.raises(ValueError, match=rf"\(3, {lying.shape[1]}\): .*transpose"):
            lineament.extract(lying)
    with pytest.raises(TypeError, match="complex128"):
        lineament.extract(ROWS.astype(complex))
    with pytest.raises(ValueError, match="columns a, b"):
        lineament.extract({"a": [1], "b": [2]})


def test_points_without_a_surface_are_refused_in_the_words_of_the_program(program: Any, tmp_path: Any) -> None:
    line = np.outer(np.arange(50.0), [1.0, 2.0, 3.0])
    np.save(tmp_path / "line.npy", line)
    said = program("extract", tmp_path / "line.npy", "-o", tmp_path / "x.obj").stderr
    with pytest.raises(lineament.CloudError) as refused:
        lineament.extract(line)
    assert str(refused.value) in said
    with pytest.raises(lineament.CloudError, match="2 distinct finite points of 3"):
        lineament.extract([[0, 0, 0], [0, 0, 0], [1, 0, 0]])


def test_rows_that_are_not_finite_are_left_out_and_counted(bracket: Any) -> None:
    holed = np.vstack([bracket, [[np.nan, 0, 0], [0, np.inf, 0]], bracket[:3]])
    report = lineament.extract(holed).report
    assert (report.read, report.dropped, report.merged) == (len(holed), 2, 3)


def test_an_output_of_no_format_is_refused(bracket: Any, tmp_path: Any) -> None:
    found = lineament.extract(bracket)
    with pytest.raises(lineament.OutputError, match="names no format"):
        found.write(tmp_path / "lines.docx")
    with pytest.raises(OSError, match="no folder"):
        found.write(tmp_path / "nowhere" / "lines.dxf")
