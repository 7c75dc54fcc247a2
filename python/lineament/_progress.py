"""Progress of long work: a function of the user's, or a bar by tqdm."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import contextmanager
from typing import Any


@contextmanager
def watcher(progress: bool | Callable[[str, float], object]) -> Generator[Callable[[str, float], object] | None, None, None]:
    """The function that is called with stage and share, if any."""
    if not isinstance(progress, bool):
        yield progress
    elif progress:
        with _bar() as bar:
            yield bar
    else:
        yield None


@contextmanager
def _bar() -> Generator[Callable[[str, float], object], None, None]:
    # The bar of notebooks in notebooks, that of terminals in terminals.
    from tqdm.auto import tqdm  # type: ignore[import-untyped, unused-ignore]

    bar: Any = tqdm(total=1.0, bar_format="{desc} {elapsed}")
    try:

        def tell(stage: str, share: float) -> None:
            bar.set_description_str(f"{stage} {share:.0%}" if 0.0 < share < 1.0 else stage)

        yield tell
    finally:
        bar.close()
