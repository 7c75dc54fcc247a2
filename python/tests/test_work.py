"""The course of long work: progress, Ctrl-C, threads, processes."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest

import lineament


def test_progress_tells_every_stage_on_the_thread_of_the_caller(bracket: Any) -> None:
    told: list[tuple[str, float, int]] = []
    found = lineament.extract(bracket, progress=lambda stage, share: told.append((stage, share, threading.get_ident())))
    stages = [stage for stage, share, _ in told if share == 0.0]
    assert stages == list(found.report.stages)
    assert {thread for *_, thread in told} == {threading.get_ident()}


def test_an_exception_in_progress_ends_the_call(bracket: Any) -> None:
    def stop(stage: str, share: float) -> None:
        if stage == "detect":
            raise KeyError(stage)

    with pytest.raises(KeyError, match="detect"):
        lineament.extract(bracket, progress=stop)
    assert len(lineament.extract(bracket).network) > 20


def test_every_function_that_takes_long_tells_of_its_progress(bracket: Any) -> None:
    calls: list[Callable[[Callable[[str, float], None]], object]] = [
        lambda tell: lineament.clean(bracket, progress=tell),
        lambda tell: lineament.classify(bracket, detector="surface-variation", progress=tell),
        lambda tell: lineament.patches(bracket, progress=tell),
    ]
    for call in calls:
        told: list[str] = []
        call(lambda stage, share: told.append(stage))
        assert told[:2] == ["localise", "localise"] and len(set(told)) >= 3


def test_a_bar_is_drawn(bracket: Any, capsys: pytest.CaptureFixture[str]) -> None:
    lineament.extract(bracket, progress=True)
    assert "recover" in capsys.readouterr().err


def test_other_threads_run_meanwhile() -> None:
    points = lineament.sample("bracket")
    counted = 0
    with ThreadPoolExecutor() as pool:
        works = [pool.submit(lineament.extract, points) for _ in range(3)]
        while not all(work.done() for work in works):
            counted += 1
            time.sleep(0.001)
    assert counted > 3
    lengths = [[strip.length for strip in work.result().network] for work in works]
    assert lengths[0] == lengths[1] == lengths[2]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork here")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_forked_process_works_too(bracket: Any) -> None:
    ours = len(lineament.extract(bracket).network)
    with multiprocessing.get_context("fork").Pool(1) as pool:
        assert pool.apply_async(_count, (bracket,)).get(timeout=60) == ours


def _count(points: Any) -> int:
    return len(lineament.extract(points).network)


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT to a process there")
def test_ctrl_c_ends_a_call_within_a_fifth_of_a_second() -> None:
    script = """
        import signal, sys, time, numpy as np, lineament
        # A shell starts what it leaves in the background without Ctrl-C.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        points = np.random.default_rng(1).random((400_000, 3)) * [100.0, 100.0, 0.01]
        def tell(stage, share):
            if stage == "neighbors" and share == 0.0:
                print("ready", flush=True)
        try:
            lineament.extract(points, progress=tell)
        except KeyboardInterrupt:
            print("interrupted", flush=True)
            # The interpreter is whole: a call after it works.
            print(len(lineament.extract(lineament.sample("cube-386")).network), flush=True)
    """
    child = subprocess.Popen([sys.executable, "-c", textwrap.dedent(script)], stdout=subprocess.PIPE, text=True)
    assert child.stdout is not None
    assert child.stdout.readline() == "ready\n"
    time.sleep(0.1)
    start = time.monotonic()
    child.send_signal(signal.SIGINT)
    assert child.stdout.readline() == "interrupted\n"
    took = time.monotonic() - start
    assert int(child.stdout.readline()) == 12
    assert child.wait(timeout=60) == 0
    assert took < 0.2, f"{took:.3f} s"
