// Distances between two picks: points of the scan, or lines.

import type { Report, Strip, Vec } from "./data";
import { type Pick, type State, figure, kindOf, place, title } from "./state";

export interface Measure {
  from: Vec;
  to: Vec;
  /** Rows of a name and a value. */
  rows: [string, string][];
}

const sub = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec, b: Vec) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const norm = (a: Vec) => Math.sqrt(dot(a, a));
const along = (a: Vec, u: Vec, t: number): Vec => [a[0] + t * u[0], a[1] + t * u[1], a[2] + t * u[2]];

/** The measure between two picks; `null` before there are two. */
export function measure(state: State): Measure | null {
  const [first, second] = state.picks;
  if (!first || !second) return null;
  const [a, b] = [first, second].map((pick) => (pick.strip === null ? null : state.report.strips[pick.strip]));
  const [from, to] = closest(parts(first, a), parts(second, b));
  const d = sub(to, from);
  const rows: [string, string][] = [
    ["between", `${named(state.report, first, a)} and ${named(state.report, second, b)}`],
    [a || b ? "least distance" : "distance", figure(norm(d))],
    ["in x, y, z", place(state.report, d)],
  ];
  if (a && b) rows.push(...pair(a, b));
  return { from, to, rows };
}

function named(report: Report, pick: Pick, strip: Strip | null): string {
  return strip ? title(strip) : `point ${place(report, pick.at)}`;
}

/** Angle between two straight lines; distance of the centres and axes of two circles. */
function pair(a: Strip, b: Strip): [string, string][] {
  if (kindOf(a) === "line" && kindOf(b) === "line") {
    const [u, v] = [a, b].map((strip) => sub(strip.curves[0].to, strip.curves[0].from));
    const angle = Math.acos(Math.min(1, Math.abs(dot(u, v)) / (norm(u) * norm(v) || 1)));
    return [["angle", `${((angle * 180) / Math.PI).toFixed(2)}°`]];
  }
  const [p, q] = [round(a), round(b)];
  if (!p || !q) return [];
  const d = sub(q.center, p.center);
  const across = Math.sqrt(Math.max(0, dot(d, d) - dot(d, p.normal) ** 2));
  return [["between centres", figure(norm(d))], ["between axes", figure(across)]];
}

/** Circle or arc of a line that is one. */
export function round(strip: Strip): { center: Vec; normal: Vec; radius: number; sigma?: number } | null {
  const curve = strip.curves.length === 1 ? strip.curves[0] : undefined;
  if (!curve?.center || !curve.normal || curve.radius === undefined) return null;
  return { center: curve.center, normal: curve.normal, radius: curve.radius, sigma: curve.sigma };
}

function parts(pick: Pick, strip: Strip | null): [Vec, Vec][] {
  if (!strip) return [[pick.at, pick.at]];
  const at = (i: number) => [...strip.points.subarray(3 * i, 3 * i + 3)] as Vec;
  const count = strip.points.length / 3;
  const out: [Vec, Vec][] = [];
  for (let i = 0; i + (strip.closed ? 0 : 1) < count; i++) out.push([at(i), at((i + 1) % count)]);
  return out;
}

function closest(a: [Vec, Vec][], b: [Vec, Vec][]): [Vec, Vec] {
  let best: [Vec, Vec] = [a[0][0], b[0][0]];
  let least = Infinity;
  for (const s of a) {
    for (const t of b) {
      const [p, q] = nearest(s, t);
      const d = norm(sub(p, q));
      if (d < least) [least, best] = [d, [p, q]];
    }
  }
  return best;
}

/** The nearest points of two segments (Ericson, Real-Time Collision Detection, section 5.1.9). */
function nearest([p, p2]: [Vec, Vec], [q, q2]: [Vec, Vec]): [Vec, Vec] {
  const [u, v, r] = [sub(p2, p), sub(q2, q), sub(p, q)];
  const [a, e, f, c, b] = [dot(u, u), dot(v, v), dot(v, r), dot(u, r), dot(u, v)];
  const clamp = (x: number) => Math.min(1, Math.max(0, x));
  if (a === 0 && e === 0) return [p, q];
  if (a === 0) return [p, along(q, v, clamp(f / e))];
  if (e === 0) return [along(p, u, clamp(-c / a)), q];
  const denominator = a * e - b * b;
  let s = denominator > 1e-12 * a * e ? clamp((b * f - c * e) / denominator) : 0;
  let t = (b * s + f) / e;
  if (t < 0) [t, s] = [0, clamp(-c / a)];
  else if (t > 1) [t, s] = [1, clamp((b - c) / a)];
  return [along(p, u, s), along(q, v, t)];
}
