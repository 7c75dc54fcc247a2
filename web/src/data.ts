// The data of a report, schema lineament-report/1, as docs/report.md describes it.

export type Vec = [number, number, number];

export interface Node {
  position: Vec;
  kind: "junction" | "corner" | "end" | "apex";
  degree: number;
}

export interface Curve {
  type: "line" | "arc" | "circle" | "ellipse" | "b-spline" | "spline";
  from: Vec;
  to: Vec;
  center?: Vec;
  normal?: Vec;
  radius?: number;
  sigma?: number;
  sweep_deg?: number;
  deviation: number;
}

export interface Strip {
  id: number;
  kind: "crease" | "border" | "rounded";
  closed: boolean;
  start: number | null;
  end: number | null;
  length: number;
  deviation: number;
  confidence: number;
  fold_deg: number | null;
  left?: number | null;
  right?: number | null;
  convex?: boolean | null;
  count: number;
  /** What it is the rim of, as the points about it tell. */
  rim?: "hole" | "boss";
  curves: Curve[];
  /** World frame, x, y, z of each point. */
  points: Float64Array;
}

export interface Patch {
  points: number;
  area: number;
  loops: { outer: boolean; closed: boolean; strips: number[] }[];
  surface: { type: string; free_form: boolean; residual: number; radius?: number; [key: string]: unknown };
}

export interface Contour {
  closed: boolean;
  depth: number;
  area: number;
  length: number;
  count: number;
  curves: { type: string; radius?: number }[];
  /** World frame. */
  points: Float64Array;
}

export interface Plane {
  height: number;
  missing?: string;
  contours: Contour[];
}

export interface Run {
  feature: "extrusion" | "taper" | "revolution";
  hole: boolean;
  from: number;
  to: number;
  range_error: [number, number];
  radius: [number | null, number | null];
  angle_deg?: number;
  residual: number;
  center: Vec;
  contours: [number, number][];
}

export interface Sections {
  axes: [Vec, Vec, Vec];
  zero: number;
  planes: Plane[];
  runs: Run[];
}

export interface Points {
  count: number;
  of: number;
  spacing: number;
  step: number;
  /** Relative to the centre of the report. */
  positions: Float32Array;
  normals: Int8Array;
  classes: Uint8Array | null;
  labels: Uint16Array | null;
}

export interface Report {
  schema: string;
  program: { name: string; version: string };
  input: { name: string; sha256: string | null; points: number };
  method: string;
  parameters: Record<string, unknown>;
  spacing: number | null;
  noise: number | null;
  crs: string | null;
  up: Vec;
  /** Of every second, third ... point of a strip that was written; 1 for all. */
  step: number;
  nodes: Node[];
  strips: Strip[];
  patches: Patch[];
  sections: Sections | null;
  points: Points;
  /** Middle of the box around everything, world frame, and half its diagonal. */
  centre: Vec;
  radius: number;
  low: Vec;
  high: Vec;
}

function bytes(text: string): Uint8Array {
  const raw = atob(text);
  const out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) out[i] = raw.charCodeAt(i);
  return out;
}

/* eslint-disable @typescript-eslint/no-explicit-any */
export function decode(text: string): Report {
  const raw: any = JSON.parse(text);
  if (raw.schema !== "lineament-report/1") throw new Error(`unknown schema ${raw.schema}`);
  const report: Report = {
    ...raw, nodes: raw.nodes ?? [], strips: strips(raw), patches: raw.patches ?? [], sections: sections(raw.sections),
    step: raw.step ?? 1,
  };
  const grid = lattice(raw.points);
  bound(report, grid);
  report.points = points(raw.points, grid, report.centre);
  return report;
}

function strips(raw: any): Strip[] {
  if (!raw.strips) return [];
  const all = new Float64Array(bytes(raw.coordinates).buffer);
  let at = 0;
  return raw.strips.map((strip: Strip, id: number) => {
    const points = all.subarray(at, at + 3 * strip.count);
    at += 3 * strip.count;
    return { ...strip, id, points };
  });
}

function sections(raw: any): Sections | null {
  if (!raw) return null;
  const all = new Float32Array(bytes(raw.coordinates).buffer);
  let at = 0;
  for (const plane of raw.planes) {
    for (const contour of plane.contours) {
      contour.points = new Float64Array(3 * contour.count);
      for (let i = 0; i < 3 * contour.count; i++) contour.points[i] = all[at + i] + raw.corner[i % 3];
      at += 3 * contour.count;
    }
  }
  return raw;
}

/** Coordinates in steps. */
function lattice(raw: any): Uint32Array {
  const source = bytes(raw.positions);
  const out = new Uint32Array(3 * raw.count);
  const width: number = raw.bytes;
  for (let i = 0; i < out.length; i++) {
    let value = 0;
    for (let b = width - 1; b >= 0; b--) value = value * 256 + source[i * width + b];
    out[i] = value;
  }
  return out;
}

function points(raw: any, grid: Uint32Array, centre: Vec): Points {
  const positions = new Float32Array(grid.length);
  const offset = [0, 1, 2].map((k) => raw.corner[k] - centre[k]);
  for (let i = 0; i < grid.length; i++) positions[i] = offset[i % 3] + grid[i] * raw.step;
  return {
    count: raw.count, of: raw.of, spacing: raw.spacing, step: raw.step, positions,
    normals: new Int8Array(bytes(raw.normals).buffer),
    classes: raw.classes ? bytes(raw.classes) : null,
    labels: raw.labels ? new Uint16Array(bytes(raw.labels).buffer) : null,
  };
}

/** Sets the box around points, lines and sections. */
function bound(report: any, grid: Uint32Array): void {
  const low: Vec = [Infinity, Infinity, Infinity];
  const high: Vec = [-Infinity, -Infinity, -Infinity];
  const include = (k: number, x: number) => {
    if (x < low[k]) low[k] = x;
    if (x > high[k]) high[k] = x;
  };
  const { corner, step } = report.points;
  for (let i = 0; i < grid.length; i++) include(i % 3, corner[i % 3] + grid[i] * step);
  for (const strip of report.strips) for (let i = 0; i < strip.points.length; i++) include(i % 3, strip.points[i]);
  for (const plane of report.sections?.planes ?? []) {
    for (const c of plane.contours) for (let i = 0; i < c.points.length; i++) include(i % 3, c.points[i]);
  }
  if (!(low[0] <= high[0])) {
    low.fill(0);
    high.fill(1);
  }
  report.low = low;
  report.high = high;
  report.centre = [0, 1, 2].map((k) => (low[k] + high[k]) / 2);
  report.radius = Math.hypot(...[0, 1, 2].map((k) => high[k] - low[k])) / 2 || 1;
}
