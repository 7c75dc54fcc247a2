// Rows of the tables: circles and arcs, all lines, runs of the slices, patches.

import type { Patch, Report, Strip } from "./data";
import { round } from "./measure";
import { type State, direction, figure, kindOf, place, title, uncertain } from "./state";

export interface Row {
  id: number;
  /** Text and the value that it is sorted by. */
  cells: [string, number | string][];
}

export interface Table {
  name: string;
  heads: string[];
  rows: Row[];
  pick: "strip" | "run" | "patch";
}

const degrees = (x: number | null | undefined) => (typeof x === "number" ? `${x.toFixed(1)}°` : "–");
const sortable = (x: number | null | undefined) => (typeof x === "number" && Number.isFinite(x) ? x : -Infinity);

export function tables(state: State): Table[] {
  const { report } = state;
  const kept = state.kept();
  const rank = (strip: Strip) => ["hole", "boss", "circle"].indexOf(holeOr(report, strip).split(" ")[0]) + 1 || 9;
  const rounds = kept.filter((strip) => round(strip)).sort((a, b) => rank(a) - rank(b) || a.id - b.id);
  return [
    ...(report.strips.length ? [rounded(report, rounds), lines(report, kept)] : []),
    ...(report.sections ? [runs(report)] : []), ...(report.patches.length ? [patches(report)] : []),
  ];
}

function rounded(report: Report, strips: Strip[]): Table {
  const rows = strips.map((strip): Row => {
    const { radius, sigma, center, normal } = round(strip)!;
    const doubled = sigma === undefined ? undefined : 2 * sigma;
    return {
      id: strip.id,
      cells: [
        [holeOr(report, strip), holeOr(report, strip)], [uncertain(2 * radius, doubled), radius],
        [uncertain(radius, sigma), radius], [figure(strip.length), strip.length],
        [degrees(strip.fold_deg), sortable(strip.fold_deg)], [place(report, center), center[0]], [direction(normal), direction(normal)],
        [strip.confidence.toFixed(2), strip.confidence],
      ],
    };
  });
  const heads = ["Name", "Diameter", "Radius", "Length", "Fold", "Centre", "Axis", "Confidence"];
  return { name: "Circles and arcs", heads, rows, pick: "strip" };
}

function lines(report: Report, strips: Strip[]): Table {
  const rows = strips.map((strip): Row => ({
    id: strip.id,
    cells: [
      [title(strip), strip.id], [strip.kind, strip.kind], [kindOf(strip), kindOf(strip)],
      [figure(strip.length), strip.length], [degrees(strip.fold_deg), sortable(strip.fold_deg)],
      [faces(report, strip), strip.left ?? -1], [strip.confidence.toFixed(2), strip.confidence],
    ],
  }));
  return { name: "Lines", heads: ["Name", "Kind", "Type", "Length", "Fold", "Faces", "Confidence"], rows, pick: "strip" };
}

/** Angle of an arc from which on it may bound a hole or a boss, degrees: an arc of less is more likely a rounded corner. */
const MOST_OF_A_TURN = 200;

/** Greatest difference of the radii of a rim and its wall, as a share. */
const SAME_RADIUS = 0.1;

/**
 * A circle by what it bounds, where the patches tell. The rim of a hole is a convex edge in an inner loop of the face that it is in, the
 * floor of a blind one a concave edge around its face; of a boss it is the other way round. Where no patches were looked for, or these
 * do not tell, the points about it do.
 */
export function holeOr(report: Report, strip: Strip): string {
  const circle = round(strip);
  const sides = [strip.left, strip.right].map((id) => (typeof id === "number" ? report.patches[id] : undefined));
  const walls = sides.filter((patch) => circle && patch && isWall(patch, circle.radius));
  const face = sides.find((patch) => patch && !walls.includes(patch));
  const loop = face?.loops.find((l) => l.strips.includes(strip.id));
  const whole = strip.closed || (strip.curves[0]?.sweep_deg ?? 0) > MOST_OF_A_TURN;
  const named = strip.rim ? `${strip.rim} ${strip.id}` : title(strip);
  if (walls.length !== 1 || !loop || !whole || typeof strip.convex !== "boolean") return named;
  // The outer loop of a face of which parts are missing may be any.
  if (loop.outer && face?.surface.type !== "plane") return named;
  return `${strip.convex !== loop.outer ? "hole" : "boss"} ${strip.id}`;
}

function isWall({ surface }: Patch, radius: number): boolean {
  if (surface.free_form || (surface.type !== "cylinder" && surface.type !== "cone")) return false;
  return surface.radius === undefined || Math.abs(surface.radius - radius) < SAME_RADIUS * radius;
}

export function faces(report: Report, strip: Strip): string {
  if (strip.left === undefined) return "–";
  const name = (id: number | null | undefined) => {
    if (typeof id !== "number") return "none";
    const surface = report.patches[id]?.surface;
    return `${surface?.free_form ? "free-form" : (surface?.type ?? "patch")} ${id}`;
  };
  return `${name(strip.left)} | ${name(strip.right)}`;
}

function runs(report: Report): Table {
  const zero = report.sections?.zero ?? 0;
  const rows = (report.sections?.runs ?? []).map((run, id): Row => {
    const [least, most] = run.radius;
    const round = least === null ? "–" : least === most ? figure(2 * least) : `${figure(2 * least)} to ${figure(2 * (most ?? 0))}`;
    const name = `${run.hole ? "hole" : run.feature} ${id}`;
    return {
      id,
      cells: [
        [name, name], [run.feature, run.feature], [round, sortable(least)],
        [uncertain(run.from - zero, run.range_error[0]), run.from], [uncertain(run.to - zero, run.range_error[1]), run.to],
        [figure(run.to - run.from), run.to - run.from], [`${run.contours.length}`, run.contours.length],
      ],
    };
  });
  return { name: "Features of the slices", heads: ["Name", "Feature", "Diameter", "From", "To", "Height", "Slices"], rows, pick: "run" };
}

function patches(report: Report): Table {
  const rows = report.patches.map((patch, id): Row => {
    const type = patch.surface.free_form ? "free-form" : patch.surface.type;
    const radius = patch.surface.free_form ? undefined : patch.surface.radius;
    return {
      id,
      cells: [
        [`patch ${id}`, id], [type, type], [figure(patch.area), patch.area], [figure(radius), sortable(radius)],
        [figure(patch.surface.residual), patch.surface.residual], [`${patch.points}`, patch.points],
      ],
    };
  });
  return { name: "Patches", heads: ["Name", "Surface", "Area", "Radius", "Residual", "Points"], rows, pick: "patch" };
}
