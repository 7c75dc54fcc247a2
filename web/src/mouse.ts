// The mouse over the scene: hover, pick, measure, drag the section plane.

import type { Overlay } from "./overlay";
import { normal, outline, reach } from "./plane";
import type { Picker } from "./pick";
import type { Stage } from "./stage";
import type { State } from "./state";

/** Pixels that the mouse may move between press and release of a click. */
const CLICK = 4;
/** Pixels beside the frame of the section plane in which it is taken hold of. */
const FRAME_REACH = 8;

export class Mouse {
  private pending = false;
  private at: [number, number] = [0, 0];
  private pressed: [number, number] | null = null;
  private dragging = false;

  constructor(
    private state: State, private stage: Stage, private picker: Picker, private overlay: Overlay,
    private picked: () => void, private moveCut: (share: number) => void,
  ) {
    const { canvas } = stage;
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerleave", () => this.hover(null));
    canvas.addEventListener("pointerdown", (event) => this.press(event), { capture: true });
    canvas.addEventListener("pointerup", (event) => this.release(event));
    canvas.addEventListener("dblclick", (event) => this.centre(event));
  }

  private press(event: PointerEvent): void {
    this.pressed = [event.offsetX, event.offsetY];
    this.dragging = event.button === 0 && this.onFrame(event.offsetX, event.offsetY);
    this.stage.controls.enabled = !this.dragging;
    if (this.dragging) this.stage.canvas.setPointerCapture(event.pointerId);
  }

  /** Whether the frame of the section plane is there. */
  private onFrame(x: number, y: number): boolean {
    const { cut, report } = this.state;
    if (!cut) return false;
    const points = outline(report, cut);
    const corners = [0, 3, 6, 9].map((i) => this.stage.project(points[i], points[i + 1], points[i + 2]));
    return corners.some(([ax, ay], i) => {
      const [bx, by] = corners[(i + 1) % 4];
      const [ux, uy] = [bx - ax, by - ay];
      const t = Math.min(1, Math.max(0, ((x - ax) * ux + (y - ay) * uy) / Math.max(1e-12, ux * ux + uy * uy)));
      return Math.hypot(ax + t * ux - x, ay + t * uy - y) < FRAME_REACH;
    });
  }

  /** Moves the section plane as far along its axis as the mouse moves along the axis on the screen. */
  private drag(x: number, y: number): void {
    const { cut, report } = this.state;
    if (!cut) return;
    const n = normal(report, cut.axis);
    const [low, high] = reach(report, n);
    const [c, d] = [low, high].map((at) => report.centre.map((m, k) => m + n[k] * (at - (low + high) / 2)));
    const [from, to] = [c, d].map((p) => this.stage.project(p[0], p[1], p[2]));
    const [ux, uy] = [to[0] - from[0], to[1] - from[1]];
    const length2 = ux * ux + uy * uy;
    if (length2 > 1) this.moveCut(((x - this.at[0]) * ux + (y - this.at[1]) * uy) / length2);
  }

  private move(event: PointerEvent): void {
    if (this.dragging) this.drag(event.offsetX, event.offsetY);
    this.at = [event.offsetX, event.offsetY];
    if (this.pending || event.buttons) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      this.hover(this.picker.line(...this.at)?.strip ?? null);
    });
  }

  private hover(strip: number | null): void {
    if (strip !== this.state.hovered) {
      this.state.hovered = strip;
      this.state.marked();
    }
    this.stage.canvas.style.cursor = strip !== null ? "pointer" : this.onFrame(...this.at) ? "move" : "";
    this.overlay.hover(...this.at);
  }

  private release(event: PointerEvent): void {
    this.stage.controls.enabled = true;
    if (this.dragging) {
      this.dragging = false;
      return;
    }
    if (!this.pressed || event.button !== 0) return;
    const [x, y] = [event.offsetX, event.offsetY];
    if (Math.hypot(x - this.pressed[0], y - this.pressed[1]) > CLICK) return;
    if (this.state.measuring) this.measure(x, y);
    else this.state.picked = this.picker.line(x, y)?.strip ?? null;
    this.state.marked();
    this.picked();
  }

  private measure(x: number, y: number): void {
    const found = this.picker.line(x, y) ?? this.picker.point(x, y);
    if (!found) return;
    const { picks } = this.state;
    this.state.picks = picks.length === 1 ? [picks[0], found] : [found];
  }

  /** Turns about the place that is clicked twice. */
  private centre(event: MouseEvent): void {
    const found = this.picker.point(event.offsetX, event.offsetY) ?? this.picker.line(event.offsetX, event.offsetY);
    if (found) this.stage.centreOn(found.at);
  }
}
