// The mouse over the scene: hover, pick, measure, drag the section plane.

import type { Overlay } from "./overlay";
import type { Picker } from "./pick";
import type { Stage } from "./stage";
import type { State } from "./state";

/** Pixels that the mouse may move between press and release of a click. */
const CLICK = 4;

export class Mouse {
  private pending = false;
  private at: [number, number] = [0, 0];
  private pressed: [number, number] | null = null;

  constructor(
    private state: State, private stage: Stage, private picker: Picker, private overlay: Overlay,
    private picked: () => void,
  ) {
    const { canvas } = stage;
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerleave", () => this.hover(null));
    canvas.addEventListener("pointerdown", (event) => (this.pressed = [event.offsetX, event.offsetY]));
    canvas.addEventListener("pointerup", (event) => this.release(event));
    canvas.addEventListener("dblclick", (event) => this.centre(event));
  }

  private move(event: PointerEvent): void {
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
    this.stage.canvas.style.cursor = strip === null ? "" : "pointer";
    this.overlay.hover(...this.at);
  }

  private release(event: PointerEvent): void {
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
