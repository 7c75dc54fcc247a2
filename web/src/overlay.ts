// What is drawn over the scene: the label beside the mouse, the measure, and the axes.

import type { Vec } from "./data";
import { el } from "./dom";
import { measure } from "./measure";
import { holeOr } from "./rows";
import type { Stage } from "./stage";
import { type State, figure, kindOf, uncertain } from "./state";
import { round } from "./measure";

const SVG = "http://www.w3.org/2000/svg";

export class Overlay {
  readonly element = el("div", { id: "overlay", "aria-hidden": "true" });
  private label = el("div", { id: "label", hidden: true });
  private drawing = document.createElementNS(SVG, "svg");

  constructor(private state: State, private stage: Stage) {
    this.element.append(this.drawing, this.label);
    stage.after.push(() => this.draw());
    state.onMark(() => this.draw());
  }

  /** The label of the line under the mouse. */
  hover(x: number, y: number): void {
    const { hovered, report } = this.state;
    this.label.hidden = hovered === null;
    if (hovered === null) return;
    const strip = report.strips[hovered];
    const circle = round(strip);
    const size = circle
      ? `⌀ ${uncertain(2 * circle.radius, circle.sigma && 2 * circle.sigma)}`
      : `${kindOf(strip)}, length ${figure(strip.length)}`;
    const fold = strip.fold_deg === null ? "" : `, fold ${strip.fold_deg.toFixed(0)}°`;
    this.label.textContent = `${holeOr(report, strip)}: ${size}${fold}`;
    const right = x > this.stage.canvas.clientWidth - 240;
    this.label.style.cssText = `left:${x + (right ? -14 : 14)}px;top:${y + 12}px;transform:translateX(${right ? "-100%" : "0"})`;
  }

  private draw(): void {
    this.drawing.replaceChildren();
    this.axes();
    const { picks } = this.state;
    for (const pick of picks) this.dot(pick.at);
    const found = measure(this.state);
    if (!found) return;
    const [a, b] = [found.from, found.to].map((p) => this.stage.project(...p));
    this.line(a, b, "measure");
    const text = this.add("text", { x: (a[0] + b[0]) / 2 + 8, y: (a[1] + b[1]) / 2 - 6, class: "measure" });
    text.textContent = found.rows[1][1];
  }

  private axes(): void {
    const { canvas, camera } = this.stage;
    const v = camera.matrixWorldInverse.elements;
    const [ox, oy] = [46, canvas.clientHeight - 46];
    for (let k = 0; k < 3; k++) {
      const [x, y] = [v[4 * k], v[4 * k + 1]];
      this.line([ox, oy], [ox + 30 * x, oy - 30 * y], `axis-${"xyz"[k]}`);
      const text = this.add("text", { x: ox + 40 * x - 4, y: oy - 40 * y + 4, class: `axis-${"xyz"[k]}` });
      text.textContent = "xyz"[k];
    }
  }

  private dot(at: Vec): void {
    const [x, y] = this.stage.project(...at);
    this.add("circle", { cx: x, cy: y, r: 5, class: "measure" });
  }

  private line(a: ArrayLike<number>, b: ArrayLike<number>, name: string): void {
    this.add("line", { x1: a[0], y1: a[1], x2: b[0], y2: b[1], class: name });
  }

  private add(tag: string, attributes: Record<string, string | number>): SVGElement {
    const element = document.createElementNS(SVG, tag);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
    this.drawing.append(element);
    return element;
  }
}
