// Standard views and keys.

import type { Vec } from "./data";
import { button, el } from "./dom";
import { type Stage, oblique } from "./stage";
import type { State } from "./state";
import { toggle } from "./theme";

/** Directions in which the eye looks, where z is up. */
const VIEWS: [string, string, Vec][] = [
  ["Top", "1", [0, 0, -1]], ["Bottom", "2", [0, 0, 1]], ["Front", "3", [0, 1, 0]], ["Back", "4", [0, -1, 0]],
  ["Left", "5", [1, 0, 0]], ["Right", "6", [-1, 0, 0]],
];

/** Angle of a step by key, radians. */
const STEP = Math.PI / 24;

export const KEYS: [string, string][] = [
  ["drag, arrows", "turn"], ["right drag, shift + arrows", "move"], ["wheel, + and -", "zoom"], ["f", "fit"],
  ["1 to 6, 7", "views"], ["o", "orthographic"], ["m", "measure"], ["Delete, x", "take the picked line out"], ["p", "points on or off"],
  ["b", "borders on or off"], ["[ and ]", "move the section plane"], ["t", "light or dark"], ["Esc", "let go"],
];

/** The same with another axis up, x and y following it in cyclic order. */
function turned([x, y, z]: Vec, up: Vec): Vec {
  return up[1] === 1 ? [x, z, -y] : up[0] === 1 ? [z, x, y] : [x, y, z];
}

export class Views {
  readonly element: HTMLElement;
  private flat = button("Orthographic", "Orthographic or perspective (o)", () => this.orthographic());
  private ruler = button("Measure", "Measure between two points or lines (m)", () => this.measuring());

  constructor(private state: State, private stage: Stage, private moveCut: (share: number) => void) {
    const { up } = state.report;
    const views = VIEWS.map(([text, key, d]) => button(text, `${text} (${key})`, () => stage.look(turned(d, up))));
    views.push(button("Oblique", "Oblique (7)", () => stage.look(oblique(up))));
    const keys = el("details", {}, el("summary", {}, "Mouse and keys"),
      el("dl", {}, ...KEYS.flatMap(([key, what]) => [el("dt", {}, key), el("dd", {}, what)])));
    const fit = button("Fit", "Bring everything into sight (f)", () => stage.fit());
    this.flat.setAttribute("aria-pressed", "false");
    this.ruler.setAttribute("aria-pressed", "false");
    this.element = el("div", {}, el("div", { class: "row" }, fit, this.flat, this.ruler,
      button("Theme", "Light or dark (t)", () => this.theme())), el("div", { class: "row" }, ...views), keys);
    window.addEventListener("keydown", (event) => this.key(event));
  }

  private orthographic(): void {
    this.stage.setOrthographic(!this.stage.isOrthographic);
    this.flat.setAttribute("aria-pressed", String(this.stage.isOrthographic));
  }

  private measuring(): void {
    this.state.measuring = !this.state.measuring;
    this.state.picks = [];
    this.ruler.setAttribute("aria-pressed", String(this.state.measuring));
    this.state.marked();
  }

  private theme(): void {
    toggle();
    this.state.changed();
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const field = event.target instanceof Element && event.target.closest("input, select");
    if (field && event.key !== "Escape") return;
    if (this.act(event.key, event.shiftKey)) event.preventDefault();
  }

  /** Does what a key says; whether it says anything. */
  private act(key: string, shift: boolean): boolean {
    const { state, stage } = this;
    const view = VIEWS.find(([, k]) => k === key);
    if (view) stage.look(turned(view[2], state.report.up));
    else if (key === "7") stage.look(oblique(state.report.up));
    else if (key === "f") stage.fit();
    else if (key === "o") this.orthographic();
    else if (key === "m") this.measuring();
    else if (key === "t") this.theme();
    else if (key === "p" || key === "b") document.getElementById(key === "p" ? "layer-points" : "layer-borders")?.click();
    else if (key === "[" || key === "]") this.moveCut(key === "[" ? -0.01 : 0.01);
    else if (key === "+" || key === "-") stage.zoom(key === "+" ? 1.2 : 1 / 1.2);
    else if (key === "Delete" || key === "x") state.takeOut();
    else if (key === "Escape") this.letGo();
    else if (key.startsWith("Arrow")) this.arrow(key, shift);
    else return false;
    return true;
  }

  private letGo(): void {
    if (this.state.measuring) this.measuring();
    Object.assign(this.state, { picked: null, run: null, patch: null, picks: [] });
    this.state.marked();
  }

  private arrow(key: string, shift: boolean): void {
    const x = key === "ArrowLeft" ? 1 : key === "ArrowRight" ? -1 : 0;
    const y = key === "ArrowUp" ? 1 : key === "ArrowDown" ? -1 : 0;
    if (shift) this.stage.pan(-0.05 * x, -0.05 * y);
    else this.stage.turn(STEP * x, STEP * y);
  }
}
