// The window of the section: the contours of the slice at the plane, or else the points beside it, in the plane.

import type { Contour } from "./data";
import { type Cut, across, normal, offset } from "./plane";
import { type State, figure } from "./state";
import { isDark } from "./theme";

/** From the world to the window. */
type Place = (p: ArrayLike<number>, at: number) => [number, number];

const SIDE = 300;
const MARGIN = 12;
/** Most points drawn. */
const MOST = 30_000;

export class CutWindow {
  readonly canvas = document.createElement("canvas");
  readonly note = document.createElement("p");

  constructor(private state: State) {
    this.canvas.width = this.canvas.height = 2 * SIDE;
    this.canvas.setAttribute("role", "img");
  }

  refresh(): void {
    const { cut } = this.state;
    this.canvas.hidden = !cut;
    this.note.hidden = !cut;
    if (!cut) return;
    const draw = this.canvas.getContext("2d");
    if (!draw) return;
    draw.fillStyle = isDark() ? "#14171c" : "#ffffff";
    draw.fillRect(0, 0, 2 * SIDE, 2 * SIDE);
    const [u, v] = across(this.state.report, cut.axis);
    const place = this.window(u, v);
    const shown = this.points(cut, place, draw);
    const slice = cut.axis === 3 ? this.contours(place, draw) : "";
    this.note.textContent = slice || `${shown} points within 1.5 spacings of the plane`;
    this.canvas.setAttribute("aria-label", `Section at ${figure(cut.at)}: ${this.note.textContent}`);
  }

  /** From the world to the window. */
  private window(u: number[], v: number[]): Place {
    const { centre, low, high } = this.state.report;
    const half = [u, v].map((a) => a.reduce((sum, x, k) => sum + (Math.abs(x) * (high[k] - low[k])) / 2, 0));
    const scale = (SIDE - MARGIN) / (Math.max(...half) || 1);
    return (p, at) => {
      let [x, y] = [0, 0];
      for (let k = 0; k < 3; k++) {
        x += u[k] * (p[at + k] - centre[k]);
        y += v[k] * (p[at + k] - centre[k]);
      }
      return [SIDE + x * scale, SIDE - y * scale];
    };
  }

  private points(
    cut: Cut, place: Place, draw: CanvasRenderingContext2D,
  ): number {
    const { points, centre } = this.state.report;
    const n = normal(this.state.report, cut.axis);
    const height = offset(this.state.report, cut);
    const near = 1.5 * (points.spacing || 0);
    draw.fillStyle = isDark() ? "#8d99a8" : "#7d8894";
    let shown = 0;
    const world = [0, 0, 0];
    for (let i = 0; i < 3 * points.count && shown < MOST; i += 3) {
      const p = points.positions;
      if (Math.abs(n[0] * p[i] + n[1] * p[i + 1] + n[2] * p[i + 2] - height) > near) continue;
      if (points.classes && points.classes[i / 3] === 4 && !this.state.layers.clutter) continue;
      for (let k = 0; k < 3; k++) world[k] = p[i + k] + centre[k];
      const [x, y] = place(world, 0);
      draw.fillRect(x - 1, y - 1, 2, 2);
      shown++;
    }
    return shown;
  }

  /** The inside of the closed contours. */
  private fill(contours: Contour[], place: Place, draw: CanvasRenderingContext2D): void {
    draw.fillStyle = isDark() ? "#2b5a4080" : "#cfe6d880";
    draw.beginPath();
    for (const { points } of contours) {
      for (let i = 0; i < points.length; i += 3) {
        if (i === 0) draw.moveTo(...place(points, i));
        else draw.lineTo(...place(points, i));
      }
      draw.closePath();
    }
    draw.fill("evenodd");
  }

  private contours(
    place: Place, draw: CanvasRenderingContext2D,
  ): string {
    const { report, plane } = this.state;
    const section = plane === null ? undefined : report.sections?.planes[plane];
    if (!section) return "";
    draw.lineWidth = 2.5;
    this.fill(section.contours.filter((c) => c.closed), place, draw);
    for (const contour of section.contours) {
      draw.strokeStyle = contour.depth % 2 ? "#c77700" : isDark() ? "#55d38a" : "#1a7f4b";
      draw.beginPath();
      for (let i = 0; i < contour.points.length; i += 3) draw.lineTo(...place(contour.points, i));
      if (contour.closed) draw.closePath();
      draw.stroke();
    }
    const curves = section.contours.flatMap((c) => c.curves);
    const circles = curves.filter((c) => c.type === "circle").map((c) => `circle ⌀ ${figure(2 * (c.radius ?? 0))}`);
    const zero = report.sections?.zero ?? 0;
    const text = section.missing ?? `${section.contours.length} contours${circles.length ? `: ${circles.join(", ")}` : ""}`;
    return `slice ${plane} at ${figure(section.height - zero)}: ${text}`;
  }
}
