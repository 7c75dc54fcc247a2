// The stage: renderer, cameras and controls. A frame is drawn only when something has changed.

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Cloud } from "./cloud";
import type { Vec } from "./data";
import { Lines } from "./lines";
import { normal, offset } from "./plane";
import type { State } from "./state";
import { theme } from "./theme";

/** Angle of view of the perspective camera, degrees. */
const ANGLE = 35;
/** Milliseconds of a frame above which fewer points are drawn while the view moves, and below which more are. */
const SLOW = 50;
const LEAST = 0.02;
/** Points of the first frame: it comes early without graphics hardware too. */
const FIRST = 50_000;
const FAST = 22;
/** Room around everything, as a factor. */
const MARGIN = 1.06;
/** Milliseconds of a whole frame up to which all points are drawn where the view does not move. */
const PATIENCE = 120;
/** Milliseconds of rest after which all points are drawn again. */
const REST = 160;

export class Stage {
  readonly renderer: THREE.WebGLRenderer;
  readonly scene = new THREE.Scene();
  readonly cloud: Cloud;
  readonly lines: Lines;
  readonly perspective = new THREE.PerspectiveCamera(ANGLE, 1, 0.01, 100);
  readonly orthographic = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.01, 100);
  camera: THREE.PerspectiveCamera | THREE.OrthographicCamera = this.perspective;
  controls!: OrbitControls;
  /** Called after each frame. */
  after: (() => void)[] = [];
  /** Counts changes of the view. */
  views = 0;
  frames = 0;
  private pending = false;
  private moving = false;
  private share = 1;
  /** Milliseconds that a frame with all points took last; none has been drawn yet. */
  private whole = Infinity;
  private resting = 0;

  constructor(readonly state: State, readonly canvas: HTMLCanvasElement) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.renderer.localClippingEnabled = true;
    THREE.ColorManagement.enabled = false;
    this.cloud = new Cloud(state);
    this.lines = new Lines(state);
    this.scene.add(this.cloud.object, this.lines.object);
    const up = new THREE.Vector3(...state.report.up);
    for (const camera of [this.perspective, this.orthographic]) camera.up.copy(up);
    this.share = Math.min(1, FIRST / Math.max(1, state.report.points.count));
    this.control();
    this.resize();
    this.look(oblique(state.report.up));
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement ?? canvas);
  }

  refresh(): void {
    this.cloud.refresh();
    this.lines.refresh();
    this.cut();
    this.draw();
  }

  /** Asks for a frame. */
  draw(moving = false): void {
    this.moving ||= moving;
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => this.frame());
  }

  get radius(): number {
    return this.state.report.radius;
  }

  /** Looks at everything along a direction. */
  look(direction: Vec): void {
    const toEye = new THREE.Vector3(...direction).normalize().negate();
    this.camera.position.copy(this.controls.target).addScaledVector(toEye, this.radius);
    this.fit();
  }

  /** Brings everything into sight from where it is looked at. */
  fit(): void {
    const toEye = this.camera.position.clone().sub(this.controls.target).normalize();
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(toEye);
    this.camera.lookAt(0, 0, 0);
    this.camera.updateMatrixWorld();
    const [away, half] = this.room();
    this.orthographic.zoom = this.orthographic.top / half;
    this.camera.position.copy(toEye.multiplyScalar(this.isOrthographic ? 3 * this.radius : away));
    this.fitted();
  }

  /** Moves the point about which the view turns, and the eye along with it. */
  centreOn(point: Vec): void {
    const target = new THREE.Vector3(...point.map((x, k) => x - this.state.report.centre[k]));
    this.camera.position.add(target.clone().sub(this.controls.target));
    this.controls.target.copy(target);
    this.controls.update();
  }

  /** Zooms by a factor. */
  zoom(factor: number): void {
    if (this.isOrthographic) this.orthographic.zoom *= factor;
    else this.camera.position.sub(this.controls.target).divideScalar(factor).add(this.controls.target);
    this.fitted();
  }

  /** Turns about the target: angles to the right and up, radians. */
  turn(right: number, up: number): void {
    const toEye = this.camera.position.clone().sub(this.controls.target);
    const frame = new THREE.Quaternion().setFromUnitVectors(this.camera.up, new THREE.Vector3(0, 1, 0));
    const angles = new THREE.Spherical().setFromVector3(toEye.applyQuaternion(frame));
    angles.theta += right;
    angles.phi -= up;
    toEye.setFromSpherical(angles.makeSafe()).applyQuaternion(frame.invert());
    this.camera.position.copy(this.controls.target).add(toEye);
    this.fitted();
  }

  /** Moves by shares of the height of the picture. */
  pan(right: number, up: number): void {
    const height = this.isOrthographic
      ? (this.orthographic.top - this.orthographic.bottom) / this.orthographic.zoom
      : 2 * Math.tan((ANGLE * Math.PI) / 360) * this.camera.position.distanceTo(this.controls.target);
    const e = this.camera.matrix.elements;
    const by = (k: number) => height * (right * e[k] + up * e[4 + k]);
    const shift = new THREE.Vector3(by(0), by(1), by(2));
    this.camera.position.add(shift);
    this.controls.target.add(shift);
    this.fitted();
  }

  setOrthographic(on: boolean): void {
    const old = this.camera;
    this.camera = on ? this.orthographic : this.perspective;
    if (old === this.camera) return;
    const away = old.position.clone().sub(this.controls.target);
    const half = Math.tan((ANGLE * Math.PI) / 360);
    if (on) {
      this.orthographic.zoom = (this.radius * 1.05) / (away.length() * half * this.narrow());
    } else {
      away.setLength((this.radius * 1.05) / (this.orthographic.zoom * half * this.narrow()));
    }
    this.camera.position.copy(this.controls.target).add(away);
    this.controls.object = this.camera;
    this.resize();
    this.controls.update();
    this.draw();
  }

  get isOrthographic(): boolean {
    return this.camera === this.orthographic;
  }

  /** World position on the screen: pixels of the page from the left and the top, and depth towards the eye. */
  project(x: number, y: number, z: number): [number, number, number] {
    const [cx, cy, cz] = this.state.report.centre;
    const v = new THREE.Vector3(x - cx, y - cy, z - cz).applyMatrix4(this.camera.matrixWorldInverse);
    const depth = -v.z;
    v.applyMatrix4(this.camera.projectionMatrix);
    const { clientWidth: w, clientHeight: h } = this.canvas;
    return [(v.x + 1) * 0.5 * w, (1 - v.y) * 0.5 * h, depth];
  }

  /** The plane up to which the scene is shown, in the frame of the scene. */
  plane(): THREE.Plane | null {
    const { cut, report } = this.state;
    if (!cut) return null;
    const sign = cut.flip ? -1 : 1;
    const n = new THREE.Vector3(...normal(report, cut.axis)).multiplyScalar(-sign);
    return new THREE.Plane(n, sign * offset(report, cut));
  }

  private control(): void {
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.zoomToCursor = true;
    this.controls.rotateSpeed = 0.9;
    this.controls.addEventListener("change", () => {
      this.views++;
      this.draw(true);
    });
  }

  private cut(): void {
    const plane = this.plane();
    const uniforms = this.cloud.material.uniforms;
    this.lines.clip(plane && !this.state.cut?.slab ? [plane] : []);
    if (!plane) {
      uniforms.cut.value.set(0, 0, 0, 0);
      uniforms.slab.value = 0;
      return;
    }
    uniforms.cut.value.set(-plane.normal.x, -plane.normal.y, -plane.normal.z, plane.constant);
    uniforms.slab.value = this.state.cut?.slab ? 1.5 * (this.state.report.points.spacing || 0) : 0;
  }

  /** The narrower half of the picture, in halves of its height. */
  private narrow(): number {
    const { clientWidth: w, clientHeight: h } = this.canvas;
    return Math.min(1, w / Math.max(1, h));
  }

  /** Distance from which the perspective camera sees the whole box, and half the height of the box in the orthographic one. */
  private room(): [number, number] {
    const { low, high, centre } = this.state.report;
    const { clientWidth: w, clientHeight: h } = this.canvas;
    const tangent = Math.tan((ANGLE * Math.PI) / 360);
    let [away, half] = [0, 0];
    for (let i = 0; i < 8; i++) {
      const corner = [0, 1, 2].map((k) => ((i >> k) & 1 ? high[k] : low[k]) - centre[k]) as Vec;
      const v = new THREE.Vector3(...corner).transformDirection(this.camera.matrixWorldInverse).multiplyScalar(Math.hypot(...corner));
      const tall = MARGIN * Math.max(Math.abs(v.y), (Math.abs(v.x) * h) / Math.max(1, w));
      away = Math.max(away, tall / tangent + v.z);
      half = Math.max(half, tall);
    }
    return [away || 1, half || 1];
  }

  private fitted(): void {
    this.controls.update();
    this.views++;
    this.draw();
  }

  private resize(): void {
    const box = this.canvas.parentElement ?? this.canvas;
    const [w, h] = [Math.max(1, box.clientWidth), Math.max(1, box.clientHeight)];
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(w, h, true);
    this.perspective.aspect = w / h;
    const half = (this.radius * 1.05) / this.narrow();
    Object.assign(this.orthographic, { left: (-half * w) / h, right: (half * w) / h, top: half, bottom: -half });
    this.views++;
    this.draw();
  }

  private frame(): void {
    this.pending = false;
    const away = this.camera.position.distanceTo(this.controls.target);
    this.perspective.near = Math.max(away - 2.2 * this.radius, away / 200);
    this.perspective.far = away + 2.2 * this.radius + this.controls.target.length();
    this.orthographic.near = away - 4 * this.radius;
    this.orthographic.far = away + 4 * this.radius;
    this.camera.updateProjectionMatrix();
    const height = this.renderer.domElement.height;
    const uniforms = this.cloud.material.uniforms;
    uniforms.ortho.value = this.isOrthographic;
    uniforms.ratio.value = this.renderer.getPixelRatio();
    uniforms.scale.value = this.isOrthographic
      ? (height * this.orthographic.zoom) / (this.orthographic.top - this.orthographic.bottom)
      : height / (2 * Math.tan((ANGLE * Math.PI) / 360));
    this.lines.ratio(this.renderer.getPixelRatio());
    this.scene.background = new THREE.Color(theme().background);
    const all = this.share === 1 || (!this.moving && this.whole < PATIENCE);
    this.moving = false;
    this.paint(all ? 1 : this.share);
    for (const act of this.after) act();
  }

  /** Draws with a share of the points; the next frames of a moving view have as many as there is time for. */
  private paint(share: number): void {
    clearTimeout(this.resting);
    const start = performance.now();
    this.cloud.detail(share);
    this.renderer.render(this.scene, this.camera);
    this.renderer.getContext().readPixels(0, 0, 1, 1, 6408, 5121, new Uint8Array(4));
    const milliseconds = performance.now() - start;
    this.frames++;
    if (share === 1) this.whole = milliseconds;
    if (milliseconds > SLOW) this.share = Math.max(LEAST, (share * SLOW) / milliseconds);
    else if (milliseconds < FAST) this.share = Math.min(1, this.share * 1.25);
    if (share < 1) this.resting = window.setTimeout(() => this.paint(1), REST);
  }
}

/** A view from above a corner. */
export function oblique(up: Vec): Vec {
  return up[1] === 1 ? [-0.6, -0.55, -0.8] : up[0] === 1 ? [-0.55, -0.8, -0.6] : [-0.6, 0.8, -0.55];
}
