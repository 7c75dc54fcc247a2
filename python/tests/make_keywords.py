"""Writes ``lineament/_keywords.py``, the types of the keyword arguments, from the table of parameters.

``python python/tests/make_keywords.py`` after a change of the table, with the package installed anew; a test compares.
"""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

import lineament

TARGET = Path(__file__).parents[1] / "lineament" / "_keywords.py"

HEAD = '''"""Types of the keyword arguments. Made by ``make_keywords.py`` from the table of parameters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, TypedDict
'''


def annotation(accepts: str) -> str:
    """The type of a parameter, from the words for the values that it accepts."""
    if accepts.startswith("auto or "):
        return f'{annotation(accepts.removeprefix("auto or "))} | Literal["auto"]'
    if accepts.startswith("one of "):
        names = re.findall(r"[\w-]+", accepts.removeprefix("one of "))
        return f"Literal[{', '.join(f'{chr(34)}{name}{chr(34)}' for name in names)}]"
    known = {"a whole number": "int", "a number": "float", "true or false": "bool"}
    found = next((kind for words, kind in known.items() if accepts.startswith(words)), None)
    return found or "str | float | Sequence[float]"


def fields(parameters: list[lineament.Parameter], short: bool) -> str:
    """The fields of a dictionary, each with its meaning, unit, range and default."""
    lines: list[str] = []
    for p in parameters:
        facts = "; ".join(fact for fact in (p.unit, p.accepts, f"default {p.default}") if fact)
        name = p.short if short else p.keyword
        lines.append(f"    {name}: {annotation(p.accepts)}")
        meaning = textwrap.fill(f'"""{p.doc} ({facts})"""', 120, initial_indent="    ", subsequent_indent="    ")
        lines.append(meaning)
    return "\n".join(lines)


def text() -> str:
    """The file."""
    table = lineament.parameters()
    lines = [p for p in table if p.section != "section"]
    cuts = [p for p in table if p.section == "section"]
    head = 'class {}(TypedDict, total=False):\n    """Parameters of {}."""\n\n'
    parts = [
        HEAD,
        head.format("Parameters", "the lines, the classes and the patches") + fields(lines, short=False),
        head.format("SectionParameters", "sections, without `section_` before their names") + fields(cuts, short=True),
    ]
    return "\n\n".join(parts) + "\n"


if __name__ == "__main__":
    TARGET.write_text(text(), encoding="utf-8")
