// What is shown: layers, filters, picks. Everything that changes it calls `changed`, and views listen.

import type { Contour, Report, Strip } from "./data";
import type { Cut } from "./plane";

export type Layer = "points" | "clutter" | "creases" | "borders" | "rounded" | "hidden" | "nodes" | "slices";
export type Colour = "plain" | "class" | "patch" | "height";
export type LineColour = "kind" | "confidence";

/** The layer of each kind of line. */
const LAYER: Record<Strip["kind"], Layer> = { crease: "creases", border: "borders", rounded: "rounded" };

/** What was picked: a line, a point of the scan or a node. */
export interface Pick {
  strip: number | null;
  /** World frame. */
  at: [number, number, number];
}

export class State {
  layers: Record<Layer, boolean> = {
    points: true, clutter: false, creases: true, borders: true, rounded: true, hidden: true, nodes: true, slices: true,
  };
  colour: Colour = "plain";
  lineColour: LineColour = "kind";
  confidence = 0;
  length = 0;
  /** Types of curves that lines must hold one of; empty for all. */
  types = new Set<string>();
  hovered: number | null = null;
  picked: number | null = null;
  measuring = false;
  picks: Pick[] = [];
  cut: Cut | null = null;
  /** The section that is shown alone. */
  plane: number | null = null;
  run: number | null = null;
  patch: number | null = null;
  /** Lines that were taken out one by one. */
  out = new Set<number>();
  private listeners: (() => void)[] = [];
  private markers: (() => void)[] = [];

  constructor(readonly report: Report) {
    // A stack of slices would hide the lines; the section plane shows the one that it lies at.
    this.layers.slices = report.strips.length === 0;
  }

  listen(listener: () => void): void {
    this.listeners.push(listener);
  }

  changed(): void {
    for (const listener of this.listeners) listener();
  }

  /** As `listen`, for what is hovered, picked or measured. */
  onMark(listener: () => void): void {
    this.markers.push(listener);
  }

  marked(): void {
    for (const listener of this.markers) listener();
  }

  /** Whether a line stays after filtering. */
  keeps(strip: Strip): boolean {
    if (this.out.has(strip.id)) return false;
    if (!this.layers[LAYER[strip.kind]]) return false;
    if (strip.confidence < this.confidence || strip.length < this.length) return false;
    return this.types.size === 0 || this.types.has(kindOf(strip));
  }

  /** Takes the line out that is picked. */
  takeOut(): void {
    if (this.picked === null) return;
    this.out.add(this.picked);
    this.picked = this.hovered = null;
    this.changed();
  }

  /** The contours on show: of all slices, or of the one at the plane. */
  contours(): { plane: number; contour: Contour }[] {
    const planes = this.report.sections?.planes ?? [];
    if (!this.layers.slices && this.plane === null) return [];
    const chosen = planes.map((_, i) => i).filter((i) => this.plane === null || i === this.plane);
    return chosen.flatMap((plane) => planes[plane].contours.map((contour) => ({ plane, contour })));
  }

  kept(): Strip[] {
    return this.report.strips.filter((strip) => this.keeps(strip));
  }
}

/** The type of a line as a whole: that of its only curve, or `mixed`. */
export function kindOf(strip: Strip): string {
  const types = new Set(strip.curves.map((curve) => curve.type));
  if (types.size === 1 && strip.curves.length === 1) return name([...types][0]);
  return strip.curves.length === 0 ? "polyline" : "mixed";
}

export function name(type: string): string {
  return type === "b-spline" ? "spline" : type;
}

/** What a line goes by: its type and its number in the other files. */
export function title(strip: Strip): string {
  const kind = kindOf(strip);
  return `${kind === "mixed" || kind === "polyline" ? strip.kind : kind} ${strip.id}`;
}

/** A number with four digits that mean something. */
export function figure(x: number | null | undefined): string {
  if (x === null || x === undefined || !Number.isFinite(x)) return "–";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e7 || size < 1e-4) return x.toExponential(3);
  return x.toFixed(Math.max(0, Math.min(7, 3 - Math.floor(Math.log10(size)))));
}

/** A value with its standard deviation, to two digits of that. */
export function uncertain(x: number | null | undefined, sigma: number | null | undefined): string {
  if (x === null || x === undefined) return "–";
  if (!sigma || !Number.isFinite(sigma)) return figure(x);
  const digits = Math.max(0, Math.min(9, 1 - Math.floor(Math.log10(sigma))));
  return `${x.toFixed(digits)} ± ${sigma.toFixed(digits)}`;
}

/** A position: as many digits as the spacing says. */
export function place(report: Report, p: number[]): string {
  const digits = report.spacing ? Math.max(0, Math.min(9, 2 - Math.floor(Math.log10(report.spacing)))) : 4;
  return p.map((x) => (Math.abs(x) < 0.5 * 10 ** -digits ? 0 : x).toFixed(digits)).join(", ");
}

/** A direction without sense: its greatest component is positive. */
export function direction(v: number[]): string {
  const most = v.reduce((best, x) => (Math.abs(x) > Math.abs(best) + 1e-9 ? x : best), 0);
  return v.map((x) => (most < 0 ? -x : x)).map((x) => (Math.abs(x) < 5e-4 ? 0 : x).toFixed(3)).join(", ");
}
