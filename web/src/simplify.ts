// Polylines with fewer points, which look the same: each segment that is drawn takes time, most of all without graphics hardware
// (Douglas and Peucker, Algorithms for the reduction of the number of points required to represent a digitized line, 1973).

export interface Polyline {
  /** x, y, z of each point. */
  points: Float64Array;
  closed: boolean;
}

/** Those of the same points between which the line stays within a tolerance of it; the first and the last among them. */
export function simplified({ points, closed }: Polyline, tolerance: number): Polyline {
  const count = points.length / 3;
  if (count < 3 || !(tolerance > 0)) return { points, closed };
  const kept = new Uint8Array(count + 1);
  const last = closed ? count : count - 1;
  kept[0] = kept[last] = 1;
  const open: [number, number][] = [[0, last]];
  for (let range = open.pop(); range; range = open.pop()) {
    const [from, to] = range;
    let [worst, most] = [-1, tolerance];
    for (let i = from + 1; i < to; i++) {
      const d = distance(points, 3 * i, 3 * from, 3 * (to % count));
      if (d > most) [worst, most] = [i, d];
    }
    if (worst < 0) continue;
    kept[worst] = 1;
    open.push([from, worst], [worst, to]);
  }
  const out: number[] = [];
  for (let i = 0; i < count; i++) if (kept[i]) out.push(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
  return { points: new Float64Array(out), closed };
}

/** Distance of a point from a segment; `i`, `a` and `b` are the places of their coordinates. */
function distance(p: Float64Array, i: number, a: number, b: number): number {
  const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
  const [vx, vy, vz] = [p[i] - p[a], p[i + 1] - p[a + 1], p[i + 2] - p[a + 2]];
  const length2 = ux * ux + uy * uy + uz * uz;
  const t = length2 > 0 ? Math.min(1, Math.max(0, (ux * vx + uy * vy + uz * vz) / length2)) : 0;
  return Math.hypot(vx - t * ux, vy - t * uy, vz - t * uz);
}
