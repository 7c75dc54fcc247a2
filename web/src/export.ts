// Files of the lines that are left: DXF of release 12 with polylines, as a report has no typed curves; CSV as the program writes it; and SVG
// of the view.

import type { Node, Strip } from "./data";
import type { State } from "./state";
import type { Stage } from "./stage";

/** The lines kept and the nodes that they have, as `Network::choose` leaves them. */
export function left(state: State): { strips: Strip[]; nodes: Node[] } {
  const strips = state.kept();
  const degree = new Array<number>(state.report.nodes.length).fill(0);
  for (const strip of strips) for (const end of [strip.start, strip.end]) if (end !== null) degree[end]++;
  const kinds = ["apex", "end", "corner"] as const;
  const nodes = state.report.nodes.flatMap((node, id): Node[] => {
    if (degree[id] === 0 && node.degree !== 0) return [];
    const kind = degree[id] === node.degree ? node.kind : (kinds[degree[id]] ?? "junction");
    return [{ ...node, kind, degree: degree[id] }];
  });
  return { strips, nodes };
}

/** A number as Rust's `{:?}` writes an f64: the shortest digits that give it back. */
export function real(x: number): string {
  if (Object.is(x, -0)) return "-0.0";
  const size = Math.abs(x);
  if (x !== 0 && (size < 1e-4 || size >= 1e16)) return x.toExponential().replace("+", "");
  const text = String(x);
  if (text.includes("e")) return x.toExponential().replace("+", "");
  return text.includes(".") ? text : `${text}.0`;
}

const LAYERS: [string, number][] = [
  ["0", 7], ["CREASE", 1], ["BORDER", 5], ["JUNCTION", 3], ["CORNER", 2], ["END", 6], ["APEX", 4], ["ROUNDED", 30],
];

function slice(plane: number): string {
  return `SLICE_${String(plane).padStart(4, "0")}`;
}

export function dxf(state: State): string {
  const { strips, nodes } = left(state);
  const out: string[] = [];
  const put = (...lines: (string | number)[]) => out.push(...lines.map(String));
  const place = (first: number, p: ArrayLike<number>) => [0, 1, 2].forEach((k) => put(first + 10 * k, real(p[k])));
  const lines = strips.filter((strip) => strip.points.length > 3);
  put(0, "SECTION", 2, "HEADER", 9, "$ACADVER", 1, "AC1009");
  const contours = state.contours();
  const box = extent([...strips, ...contours.map(({ contour }) => contour)], nodes);
  if (box) {
    put(9, "$EXTMIN");
    place(10, box[0]);
    put(9, "$EXTMAX");
    place(10, box[1]);
  }
  put(0, "ENDSEC", 0, "SECTION", 2, "TABLES", 0, "TABLE", 2, "LTYPE", 70, 1);
  put(0, "LTYPE", 2, "CONTINUOUS", 70, 0, 3, "Solid line", 72, 65, 73, 0, 40, "0.0", 0, "ENDTAB");
  const slices = [...new Set(contours.map(({ plane }) => plane))].map((plane): [string, number] => [slice(plane), 3]);
  const layers = [...LAYERS, ...slices];
  put(0, "TABLE", 2, "LAYER", 70, layers.length);
  for (const [name, colour] of layers) put(0, "LAYER", 2, name, 70, 0, 62, colour, 6, "CONTINUOUS");
  put(0, "ENDTAB", 0, "ENDSEC", 0, "SECTION", 2, "ENTITIES");
  const polyline = (layer: string, points: Float64Array, closed: boolean) => {
    put(0, "POLYLINE", 8, layer, 66, 1);
    place(10, [0, 0, 0]);
    put(70, closed ? 9 : 8);
    for (let i = 0; i < points.length; i += 3) {
      put(0, "VERTEX", 8, layer);
      place(10, points.subarray(i, i + 3));
      put(70, 32);
    }
    put(0, "SEQEND", 8, layer);
  };
  for (const strip of lines) polyline(strip.kind.toUpperCase(), strip.points, strip.closed);
  for (const { plane, contour } of contours) polyline(slice(plane), contour.points, contour.closed);
  for (const node of nodes) {
    put(0, "POINT", 8, node.kind.toUpperCase());
    place(10, node.position);
  }
  put(0, "ENDSEC", 0, "EOF");
  return out.join("\n") + "\n";
}

function extent(strips: { points: Float64Array }[], nodes: Node[]): [number[], number[]] | null {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  const include = (p: ArrayLike<number>, at: number) => {
    for (let k = 0; k < 3; k++) {
      low[k] = Math.min(low[k], p[at + k]);
      high[k] = Math.max(high[k], p[at + k]);
    }
  };
  for (const strip of strips) for (let i = 0; i < strip.points.length; i += 3) include(strip.points, i);
  for (const node of nodes) include(node.position, 0);
  return low[0] <= high[0] ? [low, high] : null;
}

/** Columns of the program's CSV; strips keep the numbers that they have in the other files. */
export function csv(state: State): string {
  const rows = ["strip,kind,closed,index,x,y,z"];
  for (const strip of state.kept()) {
    for (let i = 0; 3 * i < strip.points.length; i++) {
      const p = [...strip.points.subarray(3 * i, 3 * i + 3)].map(real).join(",");
      rows.push(`${strip.id},${strip.kind},${strip.closed ? 1 : 0},${i},${p}`);
    }
  }
  return rows.join("\n") + "\n";
}

/** Longest side of a drawing and its margin, millimetres. */
const SIDE = 200;
const MARGIN = 5;

/** The lines as they are seen now, in millimetres. */
export function svg(state: State, stage: Stage): string {
  const { strips, nodes } = left(state);
  const flat = strips.map((strip) => {
    const out: [number, number][] = [];
    for (let i = 0; i < strip.points.length; i += 3) out.push(screen(stage, strip.points, i));
    return out;
  });
  const cuts = state.contours().map(({ contour }) => {
    const out: [number, number][] = [];
    for (let i = 0; i < contour.points.length; i += 3) out.push(screen(stage, contour.points, i));
    return { out, closed: contour.closed };
  });
  const dots = nodes.map((node) => screen(stage, node.position, 0));
  const all = [...flat.flat(), ...cuts.flatMap(({ out }) => out), ...dots];
  const limit = (k: 0 | 1, pick: (a: number, b: number) => number) => all.reduce((m, p) => pick(m, p[k]), all[0]?.[k] ?? 0);
  const [x0, x1, y0, y1] = [limit(0, Math.min), limit(0, Math.max), limit(1, Math.min), limit(1, Math.max)];
  const scale = SIDE / (Math.max(x1 - x0, y1 - y0) || 1);
  const place = ([x, y]: [number, number]) => [(x - x0) * scale + MARGIN, (y - y0) * scale + MARGIN].map((v) => v.toFixed(3)).join(",");
  const [w, h] = [(x1 - x0) * scale + 2 * MARGIN, (y1 - y0) * scale + 2 * MARGIN].map((v) => v.toFixed(3));
  const group = (kind: string, colour: string) => {
    const paths = strips.flatMap((strip, i) => strip.kind !== kind || flat[i].length < 2 ? [] :
      [`<path id="strip-${strip.id}" d="M${flat[i].map(place).join(" L")}${strip.closed ? " Z" : ""}"/>`]);
    return `<g id="${kind}" fill="none" stroke="${colour}" stroke-width="0.35" stroke-linejoin="round" stroke-linecap="round">\n${paths.join("\n")}\n</g>`;
  };
  const sections = cuts.map(({ out, closed }) => `<path d="M${out.map(place).join(" L")}${closed ? " Z" : ""}"/>`);
  const slices = `<g id="slices" fill="none" stroke="#1a7f4b" stroke-width="0.25">\n${sections.join("\n")}\n</g>`;
  const circles = dots.map((p) => {
    const [x, y] = place(p).split(",");
    return `<circle cx="${x}" cy="${y}" r="0.6"/>`;
  });
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${w}mm" height="${h}mm" viewBox="0 0 ${w} ${h}">`,
    "<desc>Feature lines as seen in the report</desc>", group("crease", "#c81414"), group("border", "#1440c8"),
    ...(strips.some((strip) => strip.kind === "rounded") ? [group("rounded", "#8040a0")] : []),
    ...(sections.length ? [slices] : []),
    `<g id="nodes" fill="#202020">\n${circles.join("\n")}\n</g>`, "</svg>", "",
  ].join("\n");
}

function screen(stage: Stage, p: ArrayLike<number>, i: number): [number, number] {
  const [x, y] = stage.project(p[i], p[i + 1], p[i + 2]);
  return [x, y];
}
