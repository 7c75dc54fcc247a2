//! Texts below the options in `--help`.

pub const EXAMPLES: &str = "\
Examples:
  lineament extract --sample bracket -o bracket.obj     a generated scan, to try it out
  lineament extract part.ply                            writes part.lines.json and .obj
  lineament extract part.ply -o part.dxf -o part.json   several formats, by extension
  lineament render part.ply -o part.png                 look at it
  lineament params > tuning.toml                        every parameter, with its meaning

Exit codes:
  0    everything asked for was done
  1    of several inputs one or more failed, the others have their results
  2    the command line does not make sense
  3    an input cannot be read, or is malformed
  4    refused: a parameter is out of range, or the points have no surface
  5    an output could not be written
  130  interrupted; no file is left half-written";

pub const EXTRACT_HELP: &str = "\
Formats by extension:
  .json     everything found, in the schema lineament-network/1
  .obj      lines
  .ply      vertices and edges
  .dxf      3D polylines and points, a layer a kind
  .svg      a drawing in millimetres, seen from --view
  .geojson  line strings and points, with the reference system of the input
  .gpkg     GeoPackage, layers of lines and nodes with their properties
  .glb      binary glTF lines
  .vtp      VTK polygonal data
  .csv      a row a point

Examples:
  lineament extract part.ply
  lineament extract part.ply -o lines/part.dxf --method penalty
  lineament extract part.ply --params tuning.toml --set penalty.fold_deg=15
  lineament extract scans/*.ply -o lines/ -o 'cad/{stem}.dxf'
  zcat scan.xyz.gz | lineament extract - -o - > lines.json";

pub const CLASSIFY_HELP: &str = "\
Formats by extension:
  .npy                                the classes alone, a byte a point
  .ply .pcd .xyz .csv .las .laz .npz .parquet
                                      the points and their attributes, with class and score

Detectors, each with an automatic threshold; a point above it is 1, all others 0:
  projection            projected distance at each point's best scale (Tran 2013)
  surface-variation     least eigenvalue over the sum, 16 neighbours (Pauly 2003)
  mean-curvature        of a quadric fitted to 16 neighbours
  normal-difference     mean angle to the normals of 16 neighbours
  multiscale-variation  greatest surface variation of 8 to 32 neighbours
  persistence           share of these scales at which it is high

Examples:
  lineament classify part.ply -o part.classes.npy -o part.classes.ply
  lineament classify part.ply -o sharp.npy --detector projection
  lineament classify part.ply -o part.scores.ply --scores";

pub const PATCHES_HELP: &str = "\
Formats by extension:
  .json                           loops, neighbours, areas and surfaces, in the schema lineament-network/1
  .dxf                            the loops as 3D polylines, a layer a patch
  .ply .pcd .xyz .csv .las .laz   the points and their attributes, with the patch of each; -1 for none

The lines are those of the method `segments` unless --method, --params or --set says otherwise.

Examples:
  lineament patches part.ply -o part.patches.json -o part.patches.ply
  lineament patches part.ply -o part.dxf";

pub const RENDER_HELP: &str = "\
Creases are red, borders blue, junctions black, corners green, ends pink. What the surface hides is
faint and dashed.

Examples:
  lineament render part.ply -o part.png
  lineament render part.ply -o top.png --view top --size 2400x1800
  lineament render part.ply -o part.png --network part.lines.json";
