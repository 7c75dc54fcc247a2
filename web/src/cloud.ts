// The points: round splats as wide as their spacing, shaded by their normals, cut and coloured in the shader.

import * as THREE from "three";
import type { Points } from "./data";
import type { State } from "./state";
import { CLASSES, theme } from "./theme";

const VERTEX = `
attribute vec3 normals;
attribute float classes;
attribute float labels;
uniform float size;      // diameter of a splat, unit of the scene
uniform float scale;     // pixels for a unit at distance 1, or for a unit if orthographic
uniform float ratio;     // pixels of the screen for one of the page
uniform float back;      // shift away from the eye, so that lines on the surface lie before it
uniform bool ortho;
uniform int mode;
uniform float clutter;
uniform float smoothOnes;
uniform vec4 cut;        // plane: normal and offset
uniform float slab;      // half its width; 0 cuts one side away
uniform vec3 surface;
uniform vec3 palette[5];
uniform vec3 up;
uniform vec2 heights;
varying vec3 colour;

vec3 wheel(float h) {
  return 0.5 + 0.38 * cos(6.28318 * (h + vec3(0.0, 0.33, 0.67)));
}

void main() {
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * eye;
  vec4 behind = projectionMatrix * vec4(eye.xy, eye.z - back, 1.0);
  gl_Position.z = behind.z / behind.w * gl_Position.w;
  float pixels = ortho ? size * scale : size * scale / max(1e-9, -eye.z);
  gl_PointSize = clamp(pixels, 1.6 * ratio, 48.0 * ratio);
  float side = dot(cut.xyz, position) - cut.w;
  bool hidden = slab > 0.0 ? abs(side) > slab : side > 0.0;
  if (hidden || (classes == 4.0 ? clutter < 0.5 : smoothOnes < 0.5)) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  vec3 n = normalMatrix * normals;
  float length2 = dot(n, n);
  vec3 view = ortho ? vec3(0.0, 0.0, 1.0) : normalize(-eye.xyz);
  float facing = length2 > 0.0 ? abs(dot(n, normalize(view + vec3(0.25, 0.45, 0.0)))) / sqrt(length2) : 0.9;
  vec3 base = surface;
  if (mode == 1) base = palette[int(classes)];
  if (mode == 2) base = labels == 0.0 ? vec3(0.6) : wheel(fract(labels * 0.61803)) * (0.8 + 0.2 * fract(labels * 0.37));
  if (mode == 3) base = wheel(0.68 * (1.0 - (dot(up, position) - heights.x) / max(1e-30, heights.y - heights.x)));
  colour = base * (0.42 + 0.62 * facing);
}`;

const FRAGMENT = `
varying vec3 colour;
void main() {
  vec2 d = gl_PointCoord - 0.5;
  if (dot(d, d) > 0.25) discard;
  gl_FragColor = vec4(colour, 1.0);
}`;

const MODES = { plain: 0, class: 1, patch: 2, height: 3 };
/** Diameter of a splat and shift away from the eye, in spacings. */
const DIAMETER = 1.9;
const BACK = 1.5;

export class Cloud {
  readonly object: THREE.Points;
  readonly material: THREE.ShaderMaterial;
  private share = 1;

  constructor(private state: State) {
    const { points, centre, up, low, high } = state.report;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(points.positions, 3));
    geometry.setAttribute("normals", new THREE.BufferAttribute(points.normals, 3));
    geometry.setAttribute("classes", column(points, points.classes));
    geometry.setAttribute("labels", column(points, points.labels));
    const axis = up.findIndex((x) => x !== 0);
    this.material = new THREE.ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
        size: { value: DIAMETER * (points.spacing || 0) }, scale: { value: 1 }, ratio: { value: 1 },
        back: { value: BACK * (points.spacing || 0) }, ortho: { value: false }, mode: { value: 0 },
        clutter: { value: 0 }, smoothOnes: { value: 1 },
        cut: { value: new THREE.Vector4() }, slab: { value: 0 },
        surface: { value: new THREE.Color() }, palette: { value: CLASSES.map(([, c]) => raw(c)) },
        up: { value: new THREE.Vector3(...up) },
        heights: { value: new THREE.Vector2(low[axis] - centre[axis], high[axis] - centre[axis]) },
      },
    });
    this.object = new THREE.Points(geometry, this.material);
    this.object.frustumCulled = false;
    this.refresh();
  }

  refresh(): void {
    const { layers, colour } = this.state;
    const uniforms = this.material.uniforms;
    this.object.visible = layers.points || layers.clutter;
    uniforms.smoothOnes.value = layers.points ? 1 : 0;
    uniforms.clutter.value = layers.clutter ? 1 : 0;
    uniforms.mode.value = MODES[colour];
    uniforms.surface.value = raw(theme().surface);
    this.detail(this.share);
  }

  /** Draws this share of the points alone: every beginning of their order covers the cloud evenly. */
  detail(share: number): void {
    this.share = share;
    const count = this.state.report.points.count;
    const drawn = Math.max(Math.min(count, 20_000), Math.round(count * share));
    this.object.geometry.setDrawRange(0, drawn);
    const wider = Math.sqrt(count / Math.max(1, drawn));
    this.material.uniforms.size.value = DIAMETER * (this.state.report.points.spacing || 0) * wider;
  }
}

/** Colours of the shaders are those of the screen. */
function raw(colour: number): THREE.Color {
  return new THREE.Color().setRGB(((colour >> 16) & 255) / 255, ((colour >> 8) & 255) / 255, (colour & 255) / 255);
}

function column(points: Points, values: Uint8Array | Uint16Array | null): THREE.BufferAttribute {
  return new THREE.BufferAttribute(values ?? new Uint8Array(points.count), 1);
}
