"""The program under a limit of memory and of time, as somebody else's machine would run it."""

from __future__ import annotations

import json
import os
import re
import resource
import signal
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

MEMORY = 2 << 30
"""Bytes of address space that a run may take."""

SECONDS = 4.0
"""Seconds of the processor that a run may take: on a machine with other work its wall time says little."""

PATIENCE = 240.0
"""Seconds of wall time after which a run is ended."""

REFUSED = (2, 3, 4, 5)
"""Exit codes of a refusal."""


@dataclass
class Ran:
    """What one run did."""

    code: int
    seconds: float
    memory: float
    out: str
    err: str

    @property
    def fault(self) -> str:
        """What no run may do, in words; empty if it did none of it."""
        if self.code < 0:
            return "not ended" if self.code == -signal.SIGKILL else f"signal {-self.code}"
        if self.code not in (0, 1, *REFUSED, 130) or "panicked" in self.err:
            return f"crash, exit {self.code}"
        return f"{self.seconds:.1f} s" if self.seconds > SECONDS else ""

    @property
    def refused(self) -> bool:
        """Whether it ended with a message and no fault."""
        return not self.fault and self.code in REFUSED and self.err.strip() != ""

    @property
    def word(self) -> str:
        """Exit code and the last line that it said."""
        lines = [line for line in self.err.splitlines() if line.strip()]
        said = next((x for x in lines if "error" in x), lines[-1] if lines else "nothing said")
        return f"exit {self.code}: {re.sub(r'/[^ :]*/', '', said)[:150]}"


class Program:
    """The program to look at, with a folder for its outputs."""

    def __init__(self, path: str, data: Path, folder: Path) -> None:
        self.path, self.data, self.folder = os.path.abspath(path), data, folder

    def run(self, *args: str, memory: int = MEMORY) -> Ran:
        """Runs it with these arguments in the folder for outputs."""
        report = self.folder / ".used"
        report.unlink(missing_ok=True)
        # A process is said to have held as much memory as the one that it was forked from: a small one stands between.
        command = [sys.executable, "-I", "-S", __file__, str(memory), str(report), self.path, *args]
        with open(self.folder / ".out", "w+b") as out, open(self.folder / ".err", "w+b") as err:
            process = subprocess.Popen(
                command, cwd=self.folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err, start_new_session=True
            )
            try:
                process.wait(PATIENCE)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
            said = [bytes_of(file).decode(errors="replace") for file in (out, err)]
        if not report.exists():
            return Ran(-signal.SIGKILL, PATIENCE, 0.0, *said)
        code, seconds, kilobytes = report.read_text().split()
        return Ran(int(code), float(seconds), int(kilobytes) / 1024, *said)

    def found(self, command: str, file: str | Path, *args: str, name: str = "found.json") -> tuple[Any, Ran]:
        """The JSON that a command writes of a file, and the run; `None` if it wrote none."""
        output = self.folder / name
        output.unlink(missing_ok=True)
        ran = self.run(command, str(file), "-o", str(output), *args)
        return (json.loads(output.read_text()) if output.exists() else None), ran


def between(memory: int, report: str, *command: str) -> None:
    """Runs a command under a limit of address space; writes its exit code, seconds of the processor and kilobytes of memory."""
    pid = os.fork()
    if pid == 0:
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
        os.execv(command[0], command)
    _, status, usage = os.wait4(pid, 0)
    Path(report).write_text(f"{os.waitstatus_to_exitcode(status)} {usage.ru_utime + usage.ru_stime} {usage.ru_maxrss}")


def bytes_of(file: Any) -> bytes:
    file.seek(0)
    return bytes(file.read())


if __name__ == "__main__":
    between(int(sys.argv[1]), *sys.argv[2:])
