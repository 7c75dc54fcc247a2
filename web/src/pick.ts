// Picking on the screen: the nearest line in sight, or the foremost point of the scan.

import type { Pick, State } from "./state";
import type { Stage } from "./stage";
import type { Strip } from "./data";

/** Pixels around the mouse in which lines and points are found. */
const LINE_REACH = 7;
const POINT_REACH = 9;
/** Side of a cell of the depths, pixels. */
const CELL = 5;
/** Points that the depths are taken from. */
const SAMPLES = 200_000;
/** Depth behind the surface at which a line still counts as in sight, spacings. */
const BIAS = 4;

export class Picker {
  private views = -1;
  private cells = new Float32Array(0);
  private columns = 0;
  private projected = new Map<number, Float32Array>();

  constructor(private state: State, private stage: Stage) {}

  /** The line nearest to a place on the screen, hidden ones last, and the nearest place on it. */
  line(x: number, y: number, seen = true): Pick | null {
    this.renew();
    let best: Pick | null = null;
    let least = LINE_REACH;
    for (const strip of this.state.kept()) {
      const found = this.nearest(strip, x, y, least, seen);
      if (found) [least, best] = [found.distance, { strip: strip.id, at: found.at }];
    }
    return best;
  }

  /** The foremost point of the scan about a place on the screen. */
  point(x: number, y: number): Pick | null {
    const { points, centre } = this.state.report;
    if (!this.state.layers.points) return null;
    const project = this.projection();
    let best = -1;
    let least = Infinity;
    const bias = 2 * (points.spacing || 0);
    for (let i = 0; i < points.count; i++) {
      if (!this.shown(i)) continue;
      const [px, py, depth] = project(points.positions, 3 * i);
      const away = Math.hypot(px - x, py - y);
      const cost = depth + (bias * away) / POINT_REACH;
      if (away <= POINT_REACH && cost < least) [least, best] = [cost, i];
    }
    if (best < 0) return null;
    const at = [0, 1, 2].map((k) => points.positions[3 * best + k] + centre[k]) as [number, number, number];
    return { strip: null, at };
  }

  /** Whether a place in the world lies before the surface, or barely behind it. */
  inSight(x: number, y: number, depth: number): boolean {
    if (!this.state.layers.points || this.state.cut) return true;
    const column = Math.floor(x / CELL);
    const cell = this.cells[Math.floor(y / CELL) * this.columns + column];
    return !(cell > 0) || depth <= cell + BIAS * (this.state.report.points.spacing || 0);
  }

  /** Whether the layers and the cut leave a point of the scan. */
  private shown(i: number): boolean {
    const { classes, positions } = this.state.report.points;
    if (classes && classes[i] === 4 && !this.state.layers.clutter) return false;
    const { cut, slab } = this.stage.cloud.material.uniforms;
    const [a, b, c, d] = [cut.value.x, cut.value.y, cut.value.z, cut.value.w];
    const side = a * positions[3 * i] + b * positions[3 * i + 1] + c * positions[3 * i + 2] - d;
    return slab.value > 0 ? Math.abs(side) <= slab.value : side <= 0;
  }

  private nearest(strip: Strip, x: number, y: number, reach: number, seen: boolean) {
    const flat = this.flat(strip);
    const count = flat.length / 3;
    let best: { distance: number; at: [number, number, number] } | null = null;
    for (let i = 0; i + (strip.closed ? 0 : 1) < count; i++) {
      const j = (i + 1) % count;
      const [ax, ay, bx, by] = [flat[3 * i], flat[3 * i + 1], flat[3 * j], flat[3 * j + 1]];
      const [ux, uy] = [bx - ax, by - ay];
      const t = Math.min(1, Math.max(0, ((x - ax) * ux + (y - ay) * uy) / Math.max(1e-12, ux * ux + uy * uy)));
      const distance = Math.hypot(ax + t * ux - x, ay + t * uy - y);
      if (distance >= (best?.distance ?? reach)) continue;
      const depth = (1 - t) * flat[3 * i + 2] + t * flat[3 * j + 2];
      if (seen && !this.inSight(ax + t * ux, ay + t * uy, depth)) continue;
      const at = [0, 1, 2].map((k) => (1 - t) * strip.points[3 * i + k] + t * strip.points[3 * j + k]);
      best = { distance, at: at as [number, number, number] };
    }
    return best;
  }

  /** A line on the screen: x, y and depth of each point. */
  private flat(strip: Strip): Float32Array {
    let flat = this.projected.get(strip.id);
    if (!flat) {
      flat = new Float32Array(strip.points.length);
      for (let i = 0; i < flat.length; i += 3) {
        flat.set(this.stage.project(strip.points[i], strip.points[i + 1], strip.points[i + 2]), i);
      }
      this.projected.set(strip.id, flat);
    }
    return flat;
  }

  private renew(): void {
    if (this.views === this.stage.views) return;
    this.views = this.stage.views;
    this.projected.clear();
    const { clientWidth: w, clientHeight: h } = this.stage.canvas;
    this.columns = Math.ceil(w / CELL);
    this.cells = new Float32Array(this.columns * Math.ceil(h / CELL));
    const { points } = this.state.report;
    const project = this.projection();
    for (let i = 0; i < Math.min(points.count, SAMPLES); i++) {
      const [x, y, depth] = project(points.positions, 3 * i);
      if (x < 0 || y < 0 || x >= w || y >= h || !this.shown(i)) continue;
      const cell = Math.floor(y / CELL) * this.columns + Math.floor(x / CELL);
      if (!(this.cells[cell] > 0) || depth < this.cells[cell]) this.cells[cell] = depth;
    }
  }

  /** From positions relative to the centre to the screen, without a new object for each. */
  private projection(): (positions: Float32Array, at: number) => [number, number, number] {
    const v = this.stage.camera.matrixWorldInverse.elements;
    const p = this.stage.camera.projectionMatrix.elements;
    const { clientWidth: w, clientHeight: h } = this.stage.canvas;
    const out: [number, number, number] = [0, 0, 0];
    return (a, i) => {
      const [x, y, z] = [a[i], a[i + 1], a[i + 2]];
      const ex = v[0] * x + v[4] * y + v[8] * z + v[12];
      const ey = v[1] * x + v[5] * y + v[9] * z + v[13];
      const ez = v[2] * x + v[6] * y + v[10] * z + v[14];
      const q = p[3] * ex + p[7] * ey + p[11] * ez + p[15];
      out[0] = ((p[0] * ex + p[8] * ez + p[12]) / q + 1) * 0.5 * w;
      out[1] = (1 - (p[5] * ey + p[9] * ez + p[13]) / q) * 0.5 * h;
      out[2] = -ez;
      return out;
    };
  }
}
