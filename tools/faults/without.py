"""What was found without a file: messages that nobody reads, signals, limits, outputs over inputs, memory."""

from __future__ import annotations

import os
import resource
import signal
import struct
import subprocess
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from inputs import roof, write_las
from reports import Row
from run import Program, Ran

ROW = [
    ["sh", "-c", '"$@" 2>&-', "sh"],
    ["sh", "-c", '"$@" 2>/dev/full', "sh"],
    ["sh", "-c", '"$@" 2>&1 | head -1 >/dev/null', "sh"],
]
"""Ways to run a command whose messages nobody takes."""


def rows(program: Program) -> Iterator[Row]:
    """All points of the list below the table of `attack/README.md`."""
    folder = program.folder / "without"
    folder.mkdir(exist_ok=True)
    np.save(folder / "roof.npy", roof())
    for part in (deaf, signals, leftovers, limits, cut, outputs, values, memory):
        yield from part(program, folder)


def deaf(program: Program, folder: Path) -> Iterator[Row]:
    (folder / "bad.npy").write_bytes(b"nothing of the kind")
    for shell in ROW:
        out = folder / "deaf"
        for file in out.glob("*"):
            file.unlink()
        files = [str(folder / name) for name in ("bad.npy", "roof.npy")]
        code = subprocess.run(
            [*shell, program.path, "extract", *files, "-o", str(out) + "/"], check=False, stdout=subprocess.DEVNULL
        ).returncode
        made = sorted(p.name for p in out.glob("*"))
        right = len(made) == 2 and (code == 1 or "head" in shell[2])
        yield f"a batch with {shell[2][4:].strip()}", "panic, no outputs", f"{len(made)} outputs, exit {code}", right


def signals(program: Program, folder: Path) -> Iterator[Row]:
    np.save(folder / "many.npy", np.vstack([roof(100_000, s) for s in range(5)]))
    for name, stderr in (("standard error closed", None), ("", subprocess.DEVNULL)):
        run = f'exec "$@"{" 2>&-" if stderr is None else ""}'
        args = [program.path, "extract", str(folder / "many.npy"), "-o", str(folder / "int.json")]
        process = subprocess.Popen(["sh", "-c", run, "sh", *args], stderr=stderr)
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        code, waited = ended(process)
        left = [p.name for p in folder.iterdir() if p.name.startswith((".int", "int"))]
        yield (
            f"SIGINT{', ' if name else ''}{name}",
            "ignored" if name else "130",
            f"exit {code} after {waited:.2f} s, {left} left",
            code == 130 and waited < 2 and not left,
        )
    fifo = folder / "pipe.json"
    fifo.unlink(missing_ok=True)
    os.mkfifo(fifo)
    process = subprocess.Popen([program.path, "extract", str(folder / "roof.npy"), "-o", str(fifo)], stderr=subprocess.DEVNULL)
    time.sleep(2.0)
    process.send_signal(signal.SIGINT)
    code, waited = ended(process)
    fifo.unlink()
    yield (
        "SIGINT while writing to a FIFO that nobody reads",
        "ignored",
        f"exit {code} after {waited:.2f} s",
        code == 130 and waited < 2,
    )


def ended(process: subprocess.Popen[bytes]) -> tuple[int, float]:
    """Exit code, and the seconds until then; a process that goes on is killed."""
    begun = time.monotonic()
    try:
        return process.wait(5), time.monotonic() - begun
    except subprocess.TimeoutExpired:
        process.kill()
        return process.wait(), time.monotonic() - begun


def leftovers(program: Program, folder: Path) -> Iterator[Row]:
    out = folder / "left.json"
    for number in range(3):
        (folder / f".left.json.1-{number}.part").write_text("stale")
    own = ["unshare", "--pid", "--fork"] if os.geteuid() == 0 else []
    done = subprocess.run([*own, program.path, "extract", str(folder / "roof.npy"), "-o", str(out), "-q"], check=False)
    stale = [p.name for p in folder.glob(".left*")]
    text = f"exit {done.returncode}, {len(stale)} left" + ("" if own else " (not as process 1)")
    # Names of process 1 are held by it wherever another process 1 runs.
    yield "stale .part of process 1", "exit 5", text, done.returncode == 0 and out.exists() and (not stale or not own)


def limits(program: Program, folder: Path) -> Iterator[Row]:
    out = folder / "limit.json"
    out.write_text("old")
    done = subprocess.run(
        [program.path, "extract", str(folder / "roof.npy"), "-o", str(out)],
        check=False,
        capture_output=True,
        text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000)),
    )
    word = next((x for x in done.stderr.splitlines() if "error" in x), "nothing")[:90]
    yield (
        "a limit on file sizes",
        "death without a word",
        f"exit {done.returncode}: {word}",
        done.returncode == 5 and out.read_text() == "old",
    )


def cut(program: Program, folder: Path) -> Iterator[Row]:
    table = folder / "shrinks.xyz"
    text = b"".join(b"%.6f %.6f %.6f\n" % tuple(p) for p in roof(200_000))
    for moment in (0.01, 0.02, 0.04):
        table.write_bytes(text * 4)
        half = threading.Timer(moment, lambda: os.truncate(table, len(text)))
        half.start()
        ran = program.run("info", str(table))
        half.join()
        # The end may come before the first byte is read, or after the last.
        whole = "points      800,000" in ran.out or "points      200,000" in ran.out
        yield (
            f"a table that shrinks after {moment} s",
            "a part, exit 0",
            ran.word if ran.code else f"exit 0, {ran.out.split('points')[1].split()[0]} points",
            ran.refused or whole,
        )
    head = b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
    for name, whole in (
        ("cut.ply", head + b"0 0 0\n1 0 0.5\n0 1 0.25\n"),
        ("cut.off", b"OFF\n3 0 0\n0 0 0\n1 0 0.5\n0 1 0.25\n"),
        ("cut.pts", b"3\n0 0 0\n1 0 0.5\n0 1 0.25\n"),
    ):
        (folder / name).write_bytes(whole[:-2])
        ran = program.run("info", str(folder / name))
        yield (
            f"a last number cut in two, {name}",
            "taken",
            (said := ran.word if ran.code else warning(ran)),
            ran.refused or said != "no warning",
        )


def warning(ran: Ran) -> str:
    return next((" ".join(x.split()) for x in (ran.out + ran.err).splitlines() if "warning" in x or "note" in x), "no warning")[
        :110
    ]


def outputs(program: Program, folder: Path) -> Iterator[Row]:
    npy, points = str(folder / "roof.npy"), roof(300)
    (folder / "part.bin").write_bytes(points.astype("<f4").tobytes())
    (folder / "part.gltf").write_text(
        '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"scene":0,"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"mode":0,"attributes":'
        '{"POSITION":0}}]}],"buffers":[{"uri":"part.bin","byteLength":3600}],"bufferViews":[{"buffer":0,"byteLength":3600}],'
        '"accessors":[{"bufferView":0,"componentType":5126,"count":300,"type":"VEC3"}]}'
    )
    (folder / "tune.toml").write_text('method = "auto"\n')
    asked = {
        "a glTF's buffer": (
            ["classify", str(folder / "part.gltf"), "-o", str(folder / "part.bin"), "--input-format", "gltf"],
            folder / "part.bin",
        ),
        "the parameter file": (
            ["extract", npy, "--params", str(folder / "tune.toml"), "-o", str(folder / "tune.toml")],
            folder / "tune.toml",
        ),
    }
    (folder / "link.json").unlink(missing_ok=True)
    (folder / "link.json").symlink_to(folder / "part.bin")
    asked["a glTF's buffer by a link"] = (
        ["extract", str(folder / "part.gltf"), "-o", str(folder / "link.json")],
        folder / "part.bin",
    )
    for name, (args, held) in asked.items():
        before = held.read_bytes()
        ran = program.run(*args)
        yield f"an output that is {name}", "replaced", ran.word, ran.refused and held.read_bytes() == before
    (folder / "in.json").write_bytes(Path(npy).read_bytes())
    with open(folder / "in.json", "rb") as stdin:
        done = subprocess.run(
            [program.path, "extract", "-", "-o", str(folder / "in.json")],
            stdin=stdin,
            check=False,
            capture_output=True,
            text=True,
        )
    same = (folder / "in.json").read_bytes() == Path(npy).read_bytes()
    yield (
        "an output that standard input comes from",
        "replaced",
        f"exit {done.returncode}, {'kept' if same else 'replaced'}",
        done.returncode in (2, 5) and same,
    )
    secret = folder / "secret.json"
    secret.write_text("old")
    secret.chmod(0o600)
    program.run("extract", npy, "-o", str(secret))
    yield "mode 600", "644", oct(secret.stat().st_mode & 0o777), secret.stat().st_mode & 0o777 == 0o600
    dangling, target = folder / "dangling.json", folder / "target.json"
    target.unlink(missing_ok=True)
    dangling.unlink(missing_ok=True)
    dangling.symlink_to(target)
    program.run("extract", npy, "-o", str(dangling))
    yield (
        "a dangling link",
        "replaced by a file",
        f"link {dangling.is_symlink()}, target {target.exists()}",
        dangling.is_symlink() and target.exists(),
    )


def values(program: Program, folder: Path) -> Iterator[Row]:
    head = b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float a\x1b[31m\nend_header\n"
    (folder / "escape.ply").write_bytes(head + b"0 0 0 1\n1 0 0 1\n0 1 0 1\n")
    ran = program.run("info", str(folder / "escape.ply"))
    yield "terminal escapes from names", "printed", ran.word if ran.code else "spelled out", "\x1b" not in ran.out + ran.err
    ran = program.run("section", str(folder / "roof.npy"), "--count", "1000000", "-o", str(folder / "x.json"))
    yield "section --count 1000000", "2.9 GB", ran.word, ran.refused and ran.memory < 200
    plane = np.vstack([np.column_stack([*np.random.default_rng(1).random((2, 2000)), np.zeros(2000)]), [[1e9, 1e9, 1e9]]])
    np.save(folder / "far.npy", plane)
    ran = program.run("extract", str(folder / "far.npy"), "-o", str(folder / "x.json"))
    yield "one point at 1e9 from a plane", "collinear", ran.word, ran.code == 0
    np.save(folder / "far7.npy", np.random.default_rng(1).random((1000, 3)) + 1e7)
    ran = program.run("extract", "--voxel", "1e-12", str(folder / "far7.npy"), "-o", str(folder / "x.json"))
    yield "--voxel 1e-12 at 1e7", "all points merged", ran.word, ran.refused


def memory(program: Program, folder: Path) -> Iterator[Row]:
    one = b"OFF\n1000000 0 0\n" + b" ".join(b"%d %d 0" % (k, k % 7) for k in range(1_000_000))
    many = (
        b"ply\nformat binary_little_endian 1.0\nelement vertex 1\n"
        + b"".join(b"property float p%d\n" % k for k in range(2_000_000))
        + b"end_header\n"
    )
    for name, data in (("line.off", one), ("properties.ply", many + bytes(8_000_000))):
        yield bounded(program, folder / name, data)
    write_las(folder / "evlr.las", roof(10), "1.4", 6)
    las = bytearray((folder / "evlr.las").read_bytes())
    count = 2_000_000
    struct.pack_into("<QI", las, 235, len(las), count)
    yield bounded(program, folder / "evlr.las", bytes(las) + (bytes(2) + b"x".ljust(16, b"\0") + bytes(2 + 8 + 32)) * count)


def bounded(program: Program, file: Path, data: bytes) -> Row:
    """A file whose memory and time are to stay within bounds, refused or read."""
    file.write_bytes(data)
    # Of the points that were read few are kept, so that the measure is of the reader.
    ran = program.run("info", str(file), "--every", "100", memory=8 << 30)
    bound = 64 + 8 * len(data) / 2**20
    file.unlink()
    return (
        f"{file.name}, {len(data) >> 20} MiB",
        "over the bound",
        f"{ran.memory:.0f} of {bound:.0f} MiB, {ran.seconds:.1f} s, {ran.word[:60]}",
        ran.memory < bound and ran.seconds < 10 and ran.code in (0, 3, 4),
    )
