"""Parameters as keyword arguments. Names and defaults come from the one table of the compiled part."""

from __future__ import annotations

import difflib
import inspect
import keyword
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike, fspath
from typing import Any, TypeAlias, TypeVar, cast

import numpy as np

from lineament import _lineament
from lineament._errors import ParameterError

Function = TypeVar("Function", bound=Callable[..., Any])


@dataclass(frozen=True)
class Parameter:
    """A parameter of the table."""

    key: str
    """Section and name in the program, such as ``penalty.fold_deg``."""
    default: bool | int | float | str
    unit: str
    """The unit, empty for a plain number."""
    accepts: str
    """The values accepted, in words."""
    doc: str
    """Its meaning."""

    @property
    def keyword(self) -> str:
        """The keyword argument: the key with ``_`` in place of the dot."""
        return self.key.replace(".", "_")

    @property
    def name(self) -> str:
        """The part of the key after the dot."""
        return self.key.rpartition(".")[2]

    @property
    def short(self) -> str:
        """The name as a keyword argument of a function of its section: with ``_`` after it where it is a word of Python's."""
        return f"{self.name}_" if keyword.iskeyword(self.name) else self.name

    @property
    def section(self) -> str:
        """The part of the key before the dot."""
        return self.key.partition(".")[0]


def _value(text: str, accepts: str) -> bool | int | float | str:
    """A default as a value of Python."""
    if accepts == "true or false":
        return text == "true"
    for number in (int, float):
        try:
            return number(text)
        except ValueError:
            continue
    return text


def parameters() -> list[Parameter]:
    """Every parameter with its key, default, unit, range and meaning, in the order of the pipeline: what ``lineament params``
    prints."""
    return list(_TABLE)


_TABLE = tuple(
    Parameter(raw["key"], _value(raw["default"], raw["accepts"]), raw["unit"], raw["accepts"], raw["doc"])
    for raw in _lineament.parameters()
)
_KEYS = {parameter.keyword: parameter.key for parameter in _TABLE}


def signed(*sections: str) -> Callable[[Function], Function]:
    """Gives a function that takes ``**parameters`` the signature with the parameters of these sections and their defaults."""

    def sign(function: Function) -> Function:
        own = inspect.signature(function)
        fixed = [p for p in own.parameters.values() if p.kind is not inspect.Parameter.VAR_KEYWORD]
        tabled = [
            inspect.Parameter(p.keyword if len(sections) > 1 else p.short, inspect.Parameter.KEYWORD_ONLY, default=p.default)
            for p in _TABLE
            if p.section in sections
        ]
        function.__signature__ = own.replace(parameters=[*fixed, *tabled])  # type: ignore[attr-defined]
        return function

    return sign


ParamsLike: TypeAlias = "Mapping[str, Any] | str | PathLike[str]"
"""Parameters beside the keyword arguments: a mapping of keys to values, or of sections to such mappings; the document of a JSON
result, of which the ``parameters`` are taken; or the path of a TOML file, or of a JSON result, as ``--params`` of the program takes it."""


def settings(params: ParamsLike | None, keywords: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Keys and values as text, as ``--set`` of the program reads them: those of ``params``, then the keyword arguments."""
    unknown = next((name for name in keywords if name not in _KEYS), None)
    if unknown is not None:
        raise _no_parameter(unknown, _KEYS)
    given = _given(params)
    return [*given, *((_KEYS[name], text(value)) for name, value in keywords.items())]


def section_settings(params: ParamsLike | None, keywords: Mapping[str, Any]) -> list[tuple[str, str]]:
    """As :func:`settings`, of keyword arguments without ``section_``. Numbers and sequences for ``planes`` are counts and positions."""
    known = [p.short for p in _TABLE if p.section == "section"]
    for name in keywords:
        if name in _OPTIONS:
            raise TypeError(f"there is no parameter '{name}': did you mean 'planes={_OPTIONS[name]}'?")
        if name not in known and f"{name}_" not in known:
            raise _no_parameter(name, known)
    given = dict(keywords)
    planes = given.get("planes")
    if planes is not None and not isinstance(planes, str):
        number = isinstance(planes, (int, np.integer))
        given["planes"] = f"count:{planes}" if number else f"at:{text(list(planes))}"
    return settings(params, {f"section_{name.removesuffix('_')}": value for name, value in given.items()})


_OPTIONS = {"count": "20", "at": "[0.5, 1.0]", "step": "'every:0.5'", "every": "'every:0.5'"}
"""Options of the program that stand for ``planes``, and an example of it for each."""


def _no_parameter(name: str, known: Iterable[str]) -> TypeError:
    """The error for a name that is not known, with the one that was likely meant: one that ends in it, or else a similar one."""
    names = list(known)
    near = [k for k in names if k.endswith(f"_{name}")] or difflib.get_close_matches(name, names, n=1)
    meant = f": did you mean '{near[0]}'?" if near else ""
    return TypeError(f"there is no parameter '{name}'{meant}")


def _given(params: ParamsLike | None) -> list[tuple[str, str]]:
    if params is None:
        return []
    if isinstance(params, (str, PathLike)):
        return _lineament.parameters_of(fspath(params))
    if not isinstance(cast("object", params), Mapping):
        raise ParameterError(f"params of type {type(params).__name__}: a mapping, or the path of a TOML or JSON file, is expected")
    # The document of a result has more than its parameters.
    whole = "schema" in params and isinstance(params.get("parameters"), Mapping)
    return list(_flat(params["parameters"] if whole else params, ""))


def _flat(params: Mapping[str, Any], prefix: str) -> Iterator[tuple[str, str]]:
    for name, value in params.items():
        if isinstance(value, Mapping):
            yield from _flat(cast("Mapping[str, Any]", value), f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", text(value)


def text(value: object) -> str:
    """A value as the program reads it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return value
    if isinstance(value, np.generic):
        return text(cast("Any", value).item())
    if isinstance(value, (Sequence, np.ndarray)):
        return ",".join(text(item) for item in cast("Sequence[object]", value))
    if isinstance(value, (int, float)):
        return repr(value)
    raise ParameterError(f"a parameter of type {type(value).__name__}: a number, a truth value or a text is expected")
