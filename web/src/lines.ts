// Lines some pixels wide: those of each kind, the parts of them behind the surface, slices, and the one picked.

import * as THREE from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Contour, Strip, Vec } from "./data";
import { outline } from "./plane";
import { type Polyline, simplified } from "./simplify";
import type { State } from "./state";
import { confidence, theme } from "./theme";

/** Distance that a line may be drawn beside its points, spacings: a fraction of a pixel from where the points can be told apart. */
const TOLERANCE = 0.03;

/** A set of polylines of one colour. */
class Batch {
  readonly object = new THREE.Group();
  readonly material: LineMaterial;
  private behind: LineMaterial | null = null;
  private front: LineSegments2;
  private back: LineSegments2 | null = null;

  constructor(width: number, hidden: boolean, order: number) {
    this.material = new LineMaterial({ linewidth: width });
    this.front = new LineSegments2(new LineSegmentsGeometry(), this.material);
    this.front.frustumCulled = false;
    this.front.renderOrder = order + 1;
    this.object.add(this.front);
    if (!hidden) return;
    this.behind = new LineMaterial({
      linewidth: Math.max(1, 0.6 * width), transparent: true, opacity: 0.32, depthFunc: THREE.GreaterDepth, depthWrite: false,
    });
    this.back = new LineSegments2(new LineSegmentsGeometry(), this.behind);
    this.back.frustumCulled = false;
    this.back.renderOrder = order;
    this.object.add(this.back);
  }

  /** `colours` has the colour of each end of the segments; without, all have `colour`. */
  fill(segments: Float32Array, colour: number, seeThrough: boolean, colours: Float32Array | null = null): void {
    this.object.visible = segments.length > 0;
    const own = colours !== null && segments.length > 0;
    for (const line of [this.front, this.back]) {
      if (!line) continue;
      line.geometry.dispose();
      line.geometry = new LineSegmentsGeometry().setPositions(segments.length ? segments : new Float32Array(6));
      if (own) line.geometry.setColors(colours);
    }
    for (const material of [this.material, this.behind]) {
      if (!material) continue;
      material.color.set(own ? 0xffffff : colour);
      if (material.vertexColors !== own) material.needsUpdate = true;
      material.vertexColors = own;
    }
    if (this.back) this.back.visible = seeThrough;
  }

  clip(planes: THREE.Plane[]): void {
    this.material.clippingPlanes = planes;
    if (this.behind) this.behind.clippingPlanes = planes;
  }
}

/** End points of the segments of polylines, relative to the centre. */
export function segments(lines: Polyline[], centre: Vec): Float32Array {
  const parts = (l: Polyline) => Math.max(0, l.points.length / 3 - (l.closed ? 0 : 1));
  const out = new Float32Array(6 * lines.reduce((sum, line) => sum + parts(line), 0));
  let at = 0;
  for (const line of lines) {
    const count = line.points.length / 3;
    for (let i = 0; i < parts(line); i++) {
      const j = (i + 1) % count;
      for (let k = 0; k < 3; k++) out[at++] = line.points[3 * i + k] - centre[k];
      for (let k = 0; k < 3; k++) out[at++] = line.points[3 * j + k] - centre[k];
    }
  }
  return out;
}

/** The colours of the ends of the segments, by the confidence of their lines. */
function shades(lines: Polyline[], confidences: number[]): Float32Array {
  const out: number[] = [];
  for (const [i, line] of lines.entries()) {
    const c = confidence(confidences[i]);
    const colour = [((c >> 16) & 255) / 255, ((c >> 8) & 255) / 255, (c & 255) / 255];
    const ends = 2 * Math.max(0, line.points.length / 3 - (line.closed ? 0 : 1));
    for (let i = 0; i < ends; i++) out.push(...colour);
  }
  return new Float32Array(out);
}

export class Lines {
  readonly object = new THREE.Group();
  private creases = new Batch(2.6, true, 2);
  private borders = new Batch(2.6, true, 2);
  private rounded = new Batch(2.6, true, 2);
  private slices = new Batch(1.6, true, 2);
  private marked = new Batch(5.5, true, 4);
  private frame = new Batch(2, true, 2);
  private dots: THREE.Points;
  private simple = new WeakMap<Polyline, Polyline>();

  constructor(private state: State) {
    const round = new THREE.ShaderMaterial({
      vertexShader: DOT_VERTEX, fragmentShader: DOT_FRAGMENT, vertexColors: true,
      uniforms: { size: { value: 7 }, cut: { value: new THREE.Vector4() } },
    });
    this.dots = new THREE.Points(new THREE.BufferGeometry(), round);
    this.dots.renderOrder = 6;
    this.dots.frustumCulled = false;
    const batches = [this.creases, this.borders, this.rounded, this.slices, this.marked, this.frame];
    this.object.add(...batches.map((batch) => batch.object), this.dots);
    this.refresh();
  }

  refresh(): void {
    const { report, layers } = this.state;
    const kept = this.state.kept();
    const batches = [["crease", this.creases], ["border", this.borders], ["rounded", this.rounded]] as const;
    for (const [kind, batch] of batches) {
      const strips = kept.filter((strip) => strip.kind === kind);
      const lines = strips.map((strip) => this.drawn(strip));
      const colours = this.state.lineColour === "confidence" ? shades(lines, strips.map((strip) => strip.confidence)) : null;
      batch.fill(segments(lines, report.centre), theme()[kind], layers.hidden, colours);
    }
    this.slices.fill(segments(this.state.contours().map(({ contour }) => this.drawn(contour)), report.centre), theme().slice, false);
    const { cut } = this.state;
    this.frame.fill(cut ? segments([{ points: outline(report, cut), closed: true }], report.centre) : new Float32Array(0), 0x8a63d2, true);
    this.nodes(kept);
    this.mark();
  }

  /** A line as it is drawn. */
  private drawn(line: Polyline): Polyline {
    let drawn = this.simple.get(line);
    if (!drawn) this.simple.set(line, (drawn = simplified(line, TOLERANCE * (this.state.report.spacing ?? 0))));
    return drawn;
  }

  /** The lines under the mouse and picked. */
  mark(): void {
    const { hovered, picked, report } = this.state;
    const marked: Polyline[] = [];
    for (const id of [hovered, picked]) if (id !== null && report.strips[id]) marked.push(report.strips[id]);
    marked.push(...this.runContours(), ...this.boundary());
    this.marked.fill(segments(marked, report.centre), theme().picked, true);
  }

  clip(planes: THREE.Plane[]): void {
    for (const batch of [this.creases, this.borders, this.rounded]) batch.clip(planes);
    const [plane] = planes;
    const { cut } = (this.dots.material as THREE.ShaderMaterial).uniforms;
    if (plane) cut.value.set(-plane.normal.x, -plane.normal.y, -plane.normal.z, plane.constant);
    else cut.value.set(0, 0, 0, 0);
  }

  /** Device pixels for one of the page. */
  ratio(ratio: number): void {
    (this.dots.material as THREE.ShaderMaterial).uniforms.size.value = 7 * ratio;
  }

  /** The lines around the patch that is picked. */
  private boundary(): Strip[] {
    const { report, patch } = this.state;
    const loops = patch === null ? [] : (report.patches[patch]?.loops ?? []);
    return loops.flatMap((loop) => loop.strips.map((id) => report.strips[id]));
  }

  private runContours(): Contour[] {
    const { report, run } = this.state;
    const found = run === null ? undefined : report.sections?.runs[run];
    const contours = (found?.contours ?? []).map(([plane, index]) => report.sections?.planes[plane]?.contours[index]);
    return contours.filter((contour): contour is Contour => contour !== undefined);
  }

  private nodes(kept: Strip[]): void {
    const { report, layers } = this.state;
    const used = new Set(kept.flatMap((strip) => [strip.start, strip.end]));
    const shown = report.nodes.filter((node, id) => layers.nodes && (used.has(id) || node.degree === 0));
    const geometry = new THREE.BufferGeometry();
    const positions = shown.flatMap((node) => node.position.map((x, k) => x - report.centre[k]));
    const colours = shown.flatMap((node) => {
      const c = theme().node[node.kind] ?? 0;
      return [((c >> 16) & 255) / 255, ((c >> 8) & 255) / 255, (c & 255) / 255];
    });
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(positions, 3));
    geometry.setAttribute("color", new THREE.Float32BufferAttribute(colours, 3));
    this.dots.geometry.dispose();
    this.dots.geometry = geometry;
    this.dots.visible = shown.length > 0;
  }
}

const DOT_VERTEX = `
uniform float size;
uniform vec4 cut;
varying vec3 dotColour;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z -= 1e-4 * gl_Position.w;
  if (dot(cut.xyz, position) > cut.w) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = size;
  dotColour = color;
}`;

const DOT_FRAGMENT = `
varying vec3 dotColour;
void main() {
  vec2 d = gl_PointCoord - 0.5;
  if (dot(d, d) > 0.25) discard;
  gl_FragColor = vec4(dotColour, 1.0);
}`;
