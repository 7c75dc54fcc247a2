#!/usr/bin/env python3
"""Reads what other programs write: foreign.py POSITIONS, which is the example program `positions`. pyarrow, pandas and DuckDB
write Parquet by every codec they have, NumPy its archives, laspy and pypcd4 theirs. Prints a row a file; ends with 1 if one
differs. Programs that are not installed are skipped, saying so."""
import importlib, os, subprocess, sys, tempfile
import numpy as np

COUNT = 5000


def points():
    random = np.random.default_rng(1)
    return np.round(random.uniform(-50, 50, (COUNT, 3)) * [1, 1, .1] + [665187.25, 5648349.5, 241.5], 3)


def table(pyarrow, xyz):
    columns = {axis: xyz[:, i] for i, axis in enumerate("xyz")}
    columns["label"] = pyarrow.array([None if i % 5 == 0 else i % 7 for i in range(COUNT)], pyarrow.int32())
    columns["name"] = [f"n{i % 3}" for i in range(COUNT)]
    return pyarrow.table(columns)


def by_pyarrow(pyarrow, xyz, folder):
    parquet = importlib.import_module("pyarrow.parquet")
    for codec in ("none", "snappy", "gzip", "brotli", "lz4", "zstd"):
        for version in ("1.0", "2.0"):
            path = os.path.join(folder, f"{codec}-{version}.parquet")
            parquet.write_table(table(pyarrow, xyz), path, compression=codec, data_page_version=version, row_group_size=1500)
            yield path
    path = os.path.join(folder, "split.parquet")
    parquet.write_table(table(pyarrow, xyz), path, compression="zstd", use_dictionary=False, use_byte_stream_split=["x", "y", "z"])
    yield path
    path = os.path.join(folder, "delta.parquet")
    parquet.write_table(table(pyarrow, xyz), path, compression="zstd", use_dictionary=False,
                        column_encoding={"label": "DELTA_BINARY_PACKED", "name": "DELTA_BYTE_ARRAY"})
    yield path


def by_pandas(pandas, xyz, folder):
    for codec in ("snappy", "gzip", "zstd"):
        path = os.path.join(folder, f"pandas-{codec}.parquet")
        pandas.DataFrame(xyz, columns=list("xyz")).to_parquet(path, compression=codec)
        yield path
    path = os.path.join(folder, "pandas.csv")
    pandas.DataFrame(xyz, columns=list("xyz")).to_csv(path)
    yield path


def by_duckdb(duckdb, xyz, folder):
    base = os.path.join(folder, "duckdb.csv")
    np.savetxt(base, xyz, "%.3f", ",", header="x,y,z", comments="")
    for codec in ("snappy", "gzip", "brotli", "lz4_raw", "zstd"):
        path = os.path.join(folder, f"duckdb-{codec}.parquet")
        duckdb.sql(f"copy (from '{base}') to '{path}' (format parquet, codec '{codec}', parquet_version v2)")
        yield path


def by_numpy(numpy, xyz, folder):
    for name, write in (("stored.npz", numpy.savez), ("packed.npz", numpy.savez_compressed)):
        path = os.path.join(folder, name)
        write(path, points=xyz, label=numpy.arange(COUNT))
        yield path
    path = os.path.join(folder, "columns.npy")
    numpy.save(path, numpy.asfortranarray(xyz))
    yield path


def by_laspy(laspy, xyz, folder):
    for form in (1, 3, 6, 8):
        for extension in ("las", "laz"):
            file = laspy.create(point_format=form, file_version="1.4")
            file.header.scales, file.header.offsets = [.001] * 3, [665187.25, 5648349.5, 241.5]
            file.x, file.y, file.z = xyz.T
            path = os.path.join(folder, f"{form}.{extension}")
            file.write(path)
            yield path


def by_pypcd4(pypcd4, xyz, folder):
    for encoding in ("ascii", "binary", "binary_compressed"):
        path = os.path.join(folder, f"{encoding}.pcd")
        types = (np.float64,) * 3
        pypcd4.PointCloud.from_points(xyz, tuple("xyz"), types).save(path, encoding=pypcd4.Encoding(encoding))
        yield path


def by_trimesh(trimesh, xyz, folder):
    place = np.eye(4)
    place[:3, 3] = [665187.25, 5648349.5, 241.5]
    scene = trimesh.Scene()
    scene.add_geometry(trimesh.PointCloud(xyz - place[:3, 3]), transform=place)
    path = os.path.join(folder, "moved.glb")
    scene.export(path)
    yield path
    for name, embed in (("beside.gltf", False), ("embedded.gltf", True)):
        for part, data in trimesh.exchange.gltf.export_gltf(scene, embed_buffers=embed).items():
            path = os.path.join(folder, name if part.endswith(".gltf") else part)
            with open(path, "wb") as file:
                file.write(data)
        yield os.path.join(folder, name)


WRITERS = [("pyarrow", by_pyarrow), ("pandas", by_pandas), ("duckdb", by_duckdb), ("numpy", by_numpy), ("laspy", by_laspy),
           ("pypcd4", by_pypcd4), ("trimesh", by_trimesh)]


def main():
    program, xyz, good = sys.argv[1], points(), True
    for module, write in WRITERS:
        try:
            module = importlib.import_module(module)
        except ImportError:
            print(f"skip {module}: it is not installed")
            continue
        with tempfile.TemporaryDirectory() as folder:
            for path in write(module, xyz, folder):
                out = os.path.join(folder, "positions.f64")
                run = subprocess.run([program, path, "--to", out], capture_output=True, text=True)
                read = np.zeros((0, 3)) if run.returncode else np.fromfile(out, "<f8").reshape(-1, 3)
                # LAS scales integers, which rounds in the last digits.
                near = 1e-8 if path.endswith(("las", "laz")) else 0
                # glTF has floats under transformations in doubles.
                near = 4e-6 if path.endswith(("glb", "gltf")) else near
                same = read.shape == xyz.shape and np.abs(read - xyz).max() <= near
                print(f"{'ok  ' if same else 'DIFF'} {os.path.basename(path)} by {module.__name__}: {run.stderr.strip() or len(read)}")
                good &= same
    sys.exit(not good)


main()
