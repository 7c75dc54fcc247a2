// The viewer of a report.

import { type Report, decode } from "./data";
import { el } from "./dom";
import { Mouse } from "./mouse";
import { Overlay } from "./overlay";
import { Panel } from "./panel";
import { Picker } from "./pick";
import { Stage } from "./stage";
import { State, figure } from "./state";
import { Tables } from "./table";
import { onSystemChange } from "./theme";
import { Views } from "./views";

function start(): void {
  const text = document.getElementById("data")?.textContent ?? "";
  const report = decode(text);
  const state = new State(report);
  const main = document.getElementById("viewer")!;
  const canvas = el("canvas", { id: "scene", tabindex: "0", role: "img", "aria-label": described(report) });
  const view = el("div", { id: "view" }, canvas);
  main.append(head(report), view);
  const stage = new Stage(state, canvas);
  const overlay = new Overlay(state, stage);
  view.append(overlay.element);
  let panel: Panel | null = null;
  const views = new Views(state, stage, (share) => panel?.moveCut(share));
  panel = new Panel(state, stage, views.element);
  const tables = new Tables(state, (id) => show(state, stage, id));
  main.append(panel.element, tables.element);
  new Mouse(state, stage, new Picker(state, stage), overlay, () => tables.mark(true), (share) => panel?.moveCut(share));
  state.listen(() => stage.refresh());
  state.listen(() => tables.refresh());
  state.onMark(() => {
    stage.lines.mark();
    stage.draw();
    tables.mark();
  });
  onSystemChange(() => state.changed());
  document.body.classList.add("started");
  // For tests, and for readers with a console.
  Object.assign(window, { lineament: { report, state, stage } });
}

/** Lets the view turn about a line that was picked in a table. */
function show(state: State, stage: Stage, id: number): void {
  const { points } = state.report.strips[id];
  const sum = [0, 0, 0];
  for (let i = 0; i < points.length; i++) sum[i % 3] += points[i] / (points.length / 3);
  stage.centreOn(sum as [number, number, number]);
}

function head(report: Report): HTMLElement {
  return el("header", {}, el("h1", {}, report.input.name || "Report"), el("p", {}, described(report)));
}

function described(report: Report): string {
  const { points, strips, nodes, patches, sections } = report;
  const some = points.count < points.of ? `${count(points.count, "point")} of ${points.of.toLocaleString("en")}` : count(points.count, "point");
  const closed = strips.filter((strip) => strip.closed).length;
  return [
    points.count ? some : "", strips.length ? `${count(strips.length, "line")} (${closed} closed)` : "",
    nodes.length ? count(nodes.length, "node") : "", patches.length ? count(patches.length, "patch", "patches") : "",
    sections ? count(sections.planes.length, "slice") : "", report.spacing ? `spacing ${figure(report.spacing)}` : "",
    report.method ? `method ${report.method}` : "", report.crs ?? "",
    report.step > 1 ? `one in ${report.step} points of the lines` : "", `lineament ${report.program.version}`,
  ].filter((part) => part).join(", ");
}

function count(n: number, one: string, many = `${one}s`): string {
  return `${n.toLocaleString("en")} ${n === 1 ? one : many}`;
}

try {
  start();
} catch (error) {
  const state = document.getElementById("state");
  if (state) state.textContent = `This is a picture: the viewer could not start (${error instanceof Error ? error.message : error}).`;
  document.getElementById("viewer")?.remove();
}
