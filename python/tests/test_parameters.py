"""Parameters: of the table, of the program and of the functions."""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import make_keywords
import pytest

import lineament


def printed(text: str) -> dict[str, object]:
    """Keys and values of the TOML that ``lineament params`` prints."""
    values: dict[str, object] = {}
    section = ""
    for line in text.splitlines():
        if line.startswith("["):
            section = line.strip("[]") + "."
        elif line and not line.startswith("#"):
            key, _, value = line.partition(" = ")
            known = {"true": True, "false": False}
            values[section + key] = known[value] if value in known else _number_or_text(value)
    return values


def _number_or_text(value: str) -> object:
    if value.startswith('"'):
        return value.strip('"')
    return float(value) if "." in value or "e" in value else int(value)


def keywords_of(function: Callable[..., object]) -> dict[str, object]:
    own = inspect.signature(function).parameters.values()
    return {p.name: p.default for p in own if p.kind is p.KEYWORD_ONLY and p.name not in {"progress", "params"}}


def test_names_and_defaults_are_those_of_the_program(program: Any) -> None:
    theirs = printed(program("params").stdout)
    table = {p.key: p.default for p in lineament.parameters()}
    assert len(table) > 40 and table == theirs
    lines = {p.keyword: p.default for p in lineament.parameters() if p.section != "section"}
    assert keywords_of(lineament.extract) == lines


def test_the_types_of_keyword_arguments_are_those_of_the_table() -> None:
    assert make_keywords.TARGET.read_text(encoding="utf-8") == make_keywords.text(), "run make_keywords.py"


def test_a_parameter_has_the_effect_that_it_has_in_the_program(bracket: Any, program: Any, tmp_path: Path) -> None:
    ours, theirs = tmp_path / "ours.obj", tmp_path / "theirs.obj"
    lineament.extract(bracket, penalty_fold_deg=60, spanning_borders=False, penalty_hops="auto").write(ours)
    words = ["--set", "penalty.fold_deg=60", "--set", "spanning.borders=false"]
    assert program("extract", "--sample", "bracket", *words, "-o", theirs).returncode == 0
    assert ours.read_bytes().replace(b"array", b"sample bracket, seed 1") == theirs.read_bytes()
    lineament.extract(bracket).write(ours)
    assert ours.read_bytes().replace(b"array", b"sample bracket, seed 1") != theirs.read_bytes()


def test_keyword_arguments_go_over_a_mapping_of_sections(bracket: Any) -> None:
    file = {"method": "segments", "penalty": {"gamma": 0.25, "fold_deg": 30.0}}
    used = lineament.extract(bracket, params=file, penalty_fold_deg=20.0).parameters
    assert (used["method"], used["penalty.gamma"], used["penalty.fold_deg"]) == ("segments", "0.25", "20.0")


def test_files_and_documents_of_results_are_parameters(bracket: Any, tmp_path: Path) -> None:
    found = lineament.extract(bracket, method="segments", penalty_fold_deg=31.5)
    found.write(tmp_path / "net.json")
    (tmp_path / "t.toml").write_text('method = "segments"\n[penalty]\nfold_deg = 31.5\n')
    document = json.loads((tmp_path / "net.json").read_text())
    for params in (document, document["parameters"], tmp_path / "net.json", str(tmp_path / "t.toml"), found.parameters):
        used = lineament.extract(bracket, params=params).parameters
        assert (used["method"], used["penalty.fold_deg"]) == ("segments", "31.5")
    assert lineament.extract(bracket, params=tmp_path / "t.toml", penalty_fold_deg=20.0).parameters["penalty.fold_deg"] == "20.0"
    (tmp_path / "bad.toml").write_text("[penalty]\nwarp = 1\n")
    with pytest.raises(lineament.ParameterError, match="bad.toml:2: .*warp"):
        lineament.extract(bracket, params=tmp_path / "bad.toml")
    with pytest.raises(lineament.ParameterError, match="type int"):
        lineament.extract(bracket, params=7)  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]


def test_values_out_of_range_are_refused_in_the_words_of_the_program(bracket: Any, program: Any) -> None:
    with pytest.raises(lineament.ParameterError) as refused:
        lineament.extract(bracket, penalty_fold_deg=200)
    said = program("extract", "--sample", "bracket", "--set", "penalty.fold_deg=200", "-o", "x.obj").stderr
    assert str(refused.value) in said and "from 1 to 120" in said


def test_wrong_names_are_answered_by_the_one_that_was_meant(bracket: Any) -> None:
    with pytest.raises(TypeError, match="penalty_fold_deg"):
        lineament.extract(bracket, penalty_fold=20)  # type: ignore[call-arg]  # pyright: ignore[reportCallIssue]
    with pytest.raises(TypeError, match="'gamma': did you mean 'penalty_gamma'"):
        lineament.extract(bracket, gamma=0.4)  # type: ignore[call-arg]  # pyright: ignore[reportCallIssue]
    with pytest.raises(TypeError, match="'count': did you mean 'planes=20'"):
        lineament.section(bracket, count=20)  # type: ignore[call-arg]  # pyright: ignore[reportCallIssue]
    with pytest.raises(TypeError, match="'axes': did you mean 'axis'"):
        lineament.section(bracket, axes="x")  # type: ignore[call-arg]  # pyright: ignore[reportCallIssue]
    with pytest.raises(lineament.ParameterError, match="no parameter of this name"):
        lineament.extract(bracket, params={"penalty": {"warp": 1}})
