// The panel: views, layers, filters, the cut, the selection, and files to save.

import { CutWindow } from "./cut";
import { button, el, save } from "./dom";
import * as files from "./export";
import { measure, round } from "./measure";
import { normal, reach } from "./plane";
import { faces, holeOr } from "./rows";
import type { Stage } from "./stage";
import { type Colour, type Layer, type LineColour, type State, direction, figure, kindOf, name, place, uncertain } from "./state";
import { confidence, css } from "./theme";

export class Panel {
  readonly element = el("aside", { id: "panel", "aria-label": "Controls" });
  private selection = el("div", { id: "selection", role: "status", "aria-live": "polite" });
  private count = el("p", { id: "kept", role: "status" });
  private back = button("", "Bring back the lines that were taken out one by one", () => {
    this.state.out.clear();
    this.state.changed();
  });
  private window: CutWindow;
  private cutControls = el("div", {});
  private at = el("input", { type: "range", min: "0", max: "1000", step: "any", value: "500", "aria-label": "Place of the plane", id: "at" });

  constructor(private state: State, private stage: Stage, views: HTMLElement) {
    this.window = new CutWindow(state);
    const sections: [string, HTMLElement, boolean][] = [
      ["View", views, true], ["Selection", this.selection, true], ["Layers", this.layers(), true],
      ["Filter lines", this.filters(), true], ["Section plane", this.cut(), false], ["Save what is left", this.saving(), true],
    ];
    const { strips, sections: stack } = state.report;
    const idle = new Set([...(strips.length ? [] : ["Filter lines", "Selection"]), ...(strips.length || stack ? [] : ["Save what is left"])]);
    for (const [title, content, open] of sections.filter(([title]) => !idle.has(title))) {
      this.element.append(el("details", { open }, el("summary", {}, title), content));
    }
    state.listen(() => this.refresh());
    state.onMark(() => this.select());
    this.refresh();
  }

  private refresh(): void {
    const all = this.state.report.strips.length;
    this.count.textContent = `${this.state.kept().length} of ${all} lines`;
    this.back.hidden = this.state.out.size === 0;
    this.back.textContent = `Bring back ${this.state.out.size} taken out`;
    this.window.refresh();
    this.select();
  }

  private layers(): HTMLElement {
    const { report } = this.state;
    const { points, nodes, sections } = report;
    const has = (kind: string) => report.strips.some((strip) => strip.kind === kind);
    const clutter = points.classes?.includes(4) ?? false;
    const offered: [Layer, string, boolean][] = [
      ["points", "Points", points.count > 0], ["clutter", "Clutter", clutter], ["creases", "Creases", has("crease")],
      ["borders", "Borders", has("border")], ["rounded", "Rounded edges", has("rounded")],
      ["hidden", "Lines behind the surface", report.strips.length > 0],
      ["nodes", "Nodes", nodes.length > 0], ["slices", "Slices", sections !== null],
    ];
    const boxes = offered.filter(([, , there]) => there).map(([layer, text]) => this.box(layer, text));
    return el("div", { class: "layers" }, ...boxes, this.colours(), this.lineColours());
  }

  private box(layer: Layer, text: string): HTMLElement {
    const box = el("input", { type: "checkbox", id: `layer-${layer}`, checked: this.state.layers[layer] });
    box.addEventListener("change", () => {
      this.state.layers[layer] = box.checked;
      this.state.changed();
    });
    return el("label", { class: `layer ${layer}` }, box, text);
  }

  private colours(): HTMLElement | null {
    const { points, patches } = this.state.report;
    if (!points.count) return null;
    const offered: [Colour, string][] = [["plain", "one colour"], ["height", "height"]];
    if (points.classes) offered.push(["class", "class"]);
    if (points.labels && patches.length) offered.push(["patch", "patch"]);
    const select = el("select", { id: "colour" }, ...offered.map(([value, text]) => el("option", { value }, text)));
    select.addEventListener("change", () => {
      this.state.colour = select.value as Colour;
      this.state.changed();
    });
    return el("label", {}, "Points by ", select);
  }

  private lineColours(): HTMLElement | null {
    if (!this.state.report.strips.length) return null;
    const select = el("select", { id: "line-colour" }, el("option", { value: "kind" }, "kind"), el("option", { value: "confidence" }, "confidence"));
    const shades = el("p", { class: "shades" }, "0 ", el("span", {}), " 1");
    const show = () => {
      const steps = Array.from({ length: 9 }, (_, i) => css(confidence(i / 8)));
      shades.querySelector("span")!.style.background = `linear-gradient(to right, ${steps.join(", ")})`;
      shades.hidden = this.state.lineColour === "kind";
    };
    this.state.listen(show);
    select.addEventListener("change", () => {
      this.state.lineColour = select.value as LineColour;
      this.state.changed();
    });
    show();
    return el("div", {}, el("label", {}, "Lines by ", select), shades);
  }

  private filters(): HTMLElement {
    const { strips } = this.state.report;
    if (!strips.length) return el("p", {});
    const longest = Math.max(...strips.map((strip) => strip.length), 1e-300);
    const shortest = Math.max(Math.min(...strips.map((strip) => strip.length)), longest * 1e-4);
    const least = this.slider("confidence", "Least confidence", (share) => {
      this.state.confidence = share;
      return share.toFixed(2);
    });
    const length = this.slider("length", "Least length", (share) => {
      this.state.length = share === 0 ? 0 : shortest * (longest / shortest) ** share;
      return figure(this.state.length);
    });
    const types = [...new Set(strips.map(kindOf))].sort();
    const boxes = types.map((type) => {
      const box = el("input", { type: "checkbox", id: `type-${type}` });
      box.addEventListener("change", () => {
        if (box.checked) this.state.types.add(type);
        else this.state.types.delete(type);
        this.state.changed();
      });
      return el("label", {}, box, type);
    });
    const only = el("fieldset", { class: "types" }, el("legend", {}, "Only these types"), ...boxes);
    return el("div", {}, this.count, least, length, types.length > 1 ? only : null, this.back);
  }

  private slider(id: string, text: string, set: (share: number) => string): HTMLElement {
    const input = el("input", { type: "range", min: "0", max: "1", step: "0.01", value: "0", id });
    const shown = el("output", { for: id }, set(0));
    input.addEventListener("input", () => {
      shown.textContent = set(Number(input.value));
      this.state.changed();
    });
    return el("label", { class: "slider" }, el("span", {}, text, " ", shown), input);
  }

  private cut(): HTMLElement {
    const axes = ["x", "y", "z", ...(this.state.report.sections ? ["the slices"] : [])];
    const select = el("select", { id: "axis", "aria-label": "Axis of the plane" },
      el("option", { value: "" }, "none"), ...axes.map((axis, i) => el("option", { value: String(i) }, `across ${axis}`)));
    const flip = el("input", { type: "checkbox", id: "flip" });
    const slab = el("input", { type: "checkbox", id: "slab" });
    const set = () => {
      const axis = select.value === "" ? null : Number(select.value);
      this.cutControls.hidden = axis === null;
      const [low, high] = reach(this.state.report, normal(this.state.report, axis ?? 0));
      const place = low + (Number(this.at.value) / 1000) * (high - low);
      this.state.cut = axis === null ? null : { axis, at: place, flip: flip.checked, slab: slab.checked };
      this.state.plane = axis === 3 ? this.nearest(place) : null;
      this.state.changed();
    };
    for (const input of [select, flip, slab]) input.addEventListener("change", set);
    this.at.addEventListener("input", set);
    this.cutControls.hidden = true;
    this.cutControls.append(this.at, el("label", {}, flip, "Other side"), el("label", {}, slab, "Points at the plane alone"),
      this.window.canvas, this.window.note);
    return el("div", {}, select, this.cutControls);
  }

  /** Moves the plane by a share of its way. */
  moveCut(share: number): void {
    if (!this.state.cut) return;
    const value = Number(this.at.value) + 1000 * share;
    this.at.value = String(Math.min(1000, Math.max(0, value)));
    this.at.dispatchEvent(new Event("input"));
  }

  private nearest(place: number): number | null {
    const planes = this.state.report.sections?.planes ?? [];
    const away = (i: number) => Math.abs(planes[i].height - place);
    return planes.length ? planes.reduce((best, _, i) => (away(i) < away(best) ? i : best), 0) : null;
  }

  private saving(): HTMLElement {
    const stem = this.state.report.input.name.replace(/\.[^.]*$/, "") || "lines";
    const offer = (extension: string, type: string, text: () => string) =>
      button(extension.toUpperCase(), `Save the lines and slices on show as ${extension.toUpperCase()}`, () => save(`${stem}.${extension}`, type, text()));
    return el("div", { class: "row", id: "save" },
      offer("dxf", "image/vnd.dxf", () => files.dxf(this.state)), offer("csv", "text/csv", () => files.csv(this.state)),
      offer("svg", "image/svg+xml", () => files.svg(this.state, this.stage)));
  }

  private select(): void {
    const measured = measure(this.state);
    const id = this.state.picked ?? this.state.hovered;
    const parts: (HTMLElement | string)[] = [];
    if (this.state.measuring) parts.push(el("p", {}, measured ? "Measured:" : `Measuring: pick ${this.state.picks.length ? "the second" : "the first"} point or line.`));
    if (measured) parts.push(list(measured.rows));
    else if (id !== null) parts.push(list(this.describe(id)));
    if (this.state.picked !== null && !measured) parts.push(button("Take out", "Take this line out of view and files (x)", () => this.state.takeOut()));
    if (!parts.length) parts.push(el("p", { class: "hint" }, "Point at a line to read it, click to keep it."));
    this.selection.replaceChildren(...parts);
  }

  /** What is known of a line. */
  describe(id: number): [string, string][] {
    const { report } = this.state;
    const strip = report.strips[id];
    const circle = round(strip);
    const rows: [string, string][] = [
      ["name", holeOr(report, strip)], ["kind", `${strip.kind}${strip.closed ? ", closed" : ""}`], ["type", kindOf(strip)],
      ["length", figure(strip.length)],
    ];
    if (circle) rows.push(["radius", uncertain(circle.radius, circle.sigma)]);
    if (circle) rows.push(["diameter", uncertain(2 * circle.radius, circle.sigma && 2 * circle.sigma)]);
    if (circle) rows.push(["centre", place(report, circle.center)], ["axis", direction(circle.normal)]);
    if (strip.fold_deg !== null) rows.push(["fold", `${strip.fold_deg.toFixed(1)}°${bend(strip.convex)}`]);
    if (strip.left !== undefined) rows.push(["faces", faces(report, strip)]);
    rows.push(["confidence", strip.confidence.toFixed(2)], ["deviation", figure(strip.deviation)]);
    if (!circle) for (const curve of strip.curves.slice(0, 8)) {
      const radius = curve.radius === undefined ? "" : ` r ${uncertain(curve.radius, curve.sigma)}`;
      if (strip.curves.length > 1) rows.push(["part", `${name(curve.type)}${radius}`]);
    }
    return rows;
  }
}

function bend(convex: boolean | null | undefined): string {
  return typeof convex === "boolean" ? (convex ? ", convex" : ", concave") : "";
}

function list(rows: [string, string][]): HTMLElement {
  return el("dl", {}, ...rows.flatMap(([key, value]) => [el("dt", {}, key), el("dd", {}, value)]));
}
