// The section plane: across x, y, z, or across the slices (axis 3).

import type { Report, Vec } from "./data";

export interface Cut {
  axis: number;
  /** Its place along the axis, world unit. */
  at: number;
  /** Shows the other side. */
  flip: boolean;
  /** Shows the points at the plane alone. */
  slab: boolean;
}

/** How far its frame stands out of the box, as a share of the box. */
const MARGIN = 0.04;

const dot = (a: ArrayLike<number>, b: ArrayLike<number>) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

function unit(i: number): Vec {
  return [0, 1, 2].map((k) => (k === i % 3 ? 1 : 0)) as Vec;
}

export function normal(report: Report, axis: number): Vec {
  return axis === 3 && report.sections ? report.sections.axes[2] : unit(axis);
}

/** Two directions in the plane. */
export function across(report: Report, axis: number): [Vec, Vec] {
  if (axis === 3 && report.sections) return [report.sections.axes[0], report.sections.axes[1]];
  return axis === 1 ? [unit(0), unit(2)] : [unit(axis + 1), unit(axis + 2)];
}

/** From where to where the box reaches in a direction. */
export function reach(report: Report, direction: Vec): [number, number] {
  const { low, high } = report;
  const sum = (pick: (a: number, b: number) => number) =>
    direction.reduce((total, x, k) => total + pick(x * low[k], x * high[k]), 0);
  return [sum(Math.min), sum(Math.max)];
}

/** Corners of the frame that is shown of the plane, world frame: x, y, z of each. */
export function outline(report: Report, cut: Cut): Float64Array {
  const n = normal(report, cut.axis);
  const [u, v] = across(report, cut.axis);
  const wide = (d: Vec) => {
    const [low, high] = reach(report, d);
    return [low - MARGIN * (high - low), high + MARGIN * (high - low)];
  };
  const [[u0, u1], [v0, v1]] = [wide(u), wide(v)];
  const corner = (a: number, b: number) => [0, 1, 2].map((k) => a * u[k] + b * v[k] + cut.at * n[k]);
  return new Float64Array([corner(u0, v0), corner(u1, v0), corner(u1, v1), corner(u0, v1)].flat());
}

/** The offset of a place along an axis from that of the middle. */
export function offset(report: Report, cut: Cut): number {
  return cut.at - dot(normal(report, cut.axis), report.centre);
}
