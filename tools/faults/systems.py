"""Coordinate systems: LAS 1.2 (GeoTIFF keys), LAS 1.4 (well-known text), COPC and E57 in, GeoJSON, GeoPackage and sections out."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from pathlib import Path

from inputs import roof, write_las
from reports import Row
from run import Program

SYSTEMS = ["EPSG:25833", "EPSG:32618", "EPSG:2180", "EPSG:27700", "EPSG:31467", "EPSG:2056", "EPSG:6339"]
"""Systems of several countries, names that other programs take for EPSG:4326 among them."""


def rows(program: Program) -> Iterator[Row]:
    """For each format and system, what fiona and pyproj say of each output."""
    folder = program.folder / "systems"
    folder.mkdir(exist_ok=True)
    for name, write in (("las12.las", las12), ("las14.las", las14), ("copc.copc.laz", copc), ("scan.e57", e57)):
        for system in SYSTEMS:
            write(folder / name, system)
            read = [
                read_back(program, folder, folder / name, args, ext)
                for args in (["extract"], ["section", "--count", "3"])
                for ext in ("geojson", "gpkg")
            ]
            text = ", ".join(sorted(set(map(str, read))))
            yield f"{name} of {system}", "EPSG:4326", text, set(read) == {system}
    las14(folder / "none.las", "")
    ran = program.run("section", str(folder / "none.las"), "--count", "2", "-o", str(folder / "none.geojson"))
    line = next((x for x in ran.err.splitlines() if "reference" in x), "no word")
    yield "a scan without a system", "no word", line, line != "no word"


def read_back(program: Program, folder: Path, file: Path, args: list[str], ext: str) -> str:
    """The system that fiona and pyproj name for every layer of an output."""
    import fiona
    import pyproj

    out = folder / f"out.{ext}"
    out.unlink(missing_ok=True)
    ran = program.run(args[0], str(file), *args[1:], "-o", str(out))
    if ran.code:
        return ran.word
    named = set()
    for layer in fiona.listlayers(out):
        with fiona.open(out, layer=layer) as opened:
            code = pyproj.CRS(opened.crs_wkt).to_epsg() if opened.crs_wkt else None
            named.add(f"EPSG:{code}")
    return " ".join(sorted(named))


def placed() -> object:
    return roof(2000) + [500000, 5000000, 100]


def las12(path: Path, system: str) -> None:
    write_las(path, placed(), "1.2", 3, system)  # type: ignore[arg-type]


def las14(path: Path, system: str) -> None:
    write_las(path, placed(), "1.4", 6, system)  # type: ignore[arg-type]


def copc(path: Path, system: str) -> None:
    """LAZ of one chunk with the records of COPC: the info as the first, the hierarchy of one node behind the points."""
    import laspy
    import pyproj

    points = placed()
    header = laspy.LasHeader(version="1.4", point_format=6)
    header.scales, header.offsets = [0.001] * 3, points.min(0)  # type: ignore[attr-defined]
    header.vlrs.append(laspy.VLR("copc", 1, "copc info", bytes(160)))
    header.add_crs(pyproj.CRS(system))
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T  # type: ignore[attr-defined]
    las.write(str(path), do_compress=True)
    data = bytearray(path.read_bytes())
    (offset,) = struct.unpack_from("<I", data, 96)
    (table,) = struct.unpack_from("<q", data, offset)
    entry = struct.pack("<iiiiQii", 0, 0, 0, 0, offset + 8, table - offset - 8, len(las.x))
    place = len(data)
    data += struct.pack("<H16sHQ32s", 0, b"copc", 1000, len(entry), b"EPT hierarchy") + entry
    struct.pack_into("<QI", data, 235, place, 1)
    middle, half = (points.min(0) + points.max(0)) / 2, float((points.max(0) - points.min(0)).max() / 2)  # type: ignore[attr-defined]
    struct.pack_into("<5dQQ2d", data, 375 + 54, *middle, half, half / 16, place + 60, len(entry), 0, 0)
    path.write_bytes(data)
    with laspy.CopcReader.open(str(path)) as reader:
        assert len(reader.query()) == len(las.x)


def e57(path: Path, system: str) -> None:
    import pye57
    import pyproj

    path.unlink(missing_ok=True)
    points = placed()
    text = pye57.libe57.StringNode
    # The writer sets this member to an empty text, once and for all.
    pye57.libe57.StringNode = lambda file, value="": text(file, value or pyproj.CRS(system).to_wkt())
    file = pye57.E57(str(path), mode="w")
    pye57.libe57.StringNode = text
    file.write_scan_raw({f"cartesian{a}": points[:, k].copy() for k, a in enumerate("XYZ")})  # type: ignore[index]
    file.close()
