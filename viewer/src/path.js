// The tool path as ribbons of constant width on the screen, in levels of detail: each level leaves out the locations that
// lie within its tolerance of the line between their neighbors, and the level is chosen by what a pixel can show.
import * as THREE from "three";
import {GUN, START} from "./data.js";

const vertexShader = `
attribute vec4 a; attribute vec4 b; attribute float value;
uniform vec2 view; uniform float width; uniform float head; uniform vec2 chosen; uniform vec3 palette[6]; uniform float coloring;
varying vec3 ink; varying float fade; varying vec3 world;
#include <clipping_planes_pars_vertex>
vec3 ramp(float t) {
  t = clamp(t, 0.0, 1.0);
  vec3 low = vec3(0.13, 0.40, 0.80), middle = vec3(0.16, 0.65, 0.35), high = vec3(0.85, 0.15, 0.12), yellow = vec3(0.93, 0.72, 0.10);
  return t < 0.34 ? mix(low, middle, t / 0.34) : t < 0.67 ? mix(middle, yellow, (t - 0.34) / 0.33) : mix(yellow, high, (t - 0.67) / 0.33);
}
void main() {
  float index = b.w;
  float kind = mod(floor(value), 8.0);
  float amount = fract(value) * 1.0001;
  vec4 p = projectionMatrix * modelViewMatrix * vec4(a.xyz, 1.0);
  vec4 q = projectionMatrix * modelViewMatrix * vec4(b.xyz, 1.0);
  vec2 way = (q.xy / q.w - p.xy / p.w) * view;
  float length2 = length(way);
  vec2 along = length2 > 0.0 ? way / length2 : vec2(1.0, 0.0);
  bool marked = index >= chosen.x && index < chosen.y;
  float half_ = (marked ? 2.0 : 1.0) * width * (kind == 1.0 ? 0.62 : kind == 4.0 ? 1.5 : 1.0) * 0.5;
  vec2 side = vec2(-along.y, along.x) * position.y * half_ + along * (position.x - 0.5) * half_;
  vec4 end = position.x < 0.5 ? p : q;
  end.xy += side / view * 2.0 * end.w;
  end.z -= (marked ? 2e-4 : 5e-5) * end.w;
  ink = coloring > 0.5 ? (amount < 0.0005 ? palette[5] : ramp((amount - 0.001) / 0.997)) : palette[int(kind)];
  if (marked) ink = palette[0];
  fade = index > head ? 0.16 : 1.0;
  if (kind == 0.0) end = vec4(2.0, 2.0, 2.0, 1.0);
  vec4 mvPosition = modelViewMatrix * vec4(position.x < 0.5 ? a.xyz : b.xyz, 1.0);
  #include <clipping_planes_vertex>
  gl_Position = end;
}`;
const fragmentShader = `
varying vec3 ink; varying float fade;
#include <clipping_planes_pars_fragment>
void main() {
  #include <clipping_planes_fragment>
  gl_FragColor = vec4(ink, fade);
}`;

const levelRatios = [0, 2e-4, 1e-3, 5e-3]; // of the size of the path

function keepAll(n) {
  const kept = new Uint32Array(n);
  for (let i = 0; i < n; ++i) kept[i] = i;
  return kept;
}

// Keeps a location where the kind changes, and where the chord over the run would miss one by more than the tolerance. The
// test is that of a cone of directions from the last kept place (Reumann and Witkam), so that it takes linear time.
function thin(scene, from, tolerance) {
  const p = scene.places, kept = [0];
  let anchor = 0, dx = 0, dy = 0, dz = 0, has = false;
  for (let k = 1; k < from.length; ++k) {
    const i = from[k], before = from[k - 1];
    let keep = scene.kinds[i] !== scene.kinds[before] || (scene.kinds[i] & 15) === START;
    if (!keep && has) {
      const x = p[3 * i] - p[3 * anchor], y = p[3 * i + 1] - p[3 * anchor + 1], z = p[3 * i + 2] - p[3 * anchor + 2];
      const t = x * dx + y * dy + z * dz;
      keep = t < 0 || x * x + y * y + z * z - t * t > tolerance * tolerance;
    }
    if (keep && kept[kept.length - 1] !== before) kept.push(before);
    if (keep) anchor = before;
    if (keep || !has) {
      const x = p[3 * i] - p[3 * anchor], y = p[3 * i + 1] - p[3 * anchor + 1], z = p[3 * i + 2] - p[3 * anchor + 2];
      const length = Math.hypot(x, y, z);
      has = length > tolerance;
      if (has) { dx = x / length; dy = y / length; dz = z / length; }
    }
  }
  if (kept[kept.length - 1] !== from[from.length - 1]) kept.push(from[from.length - 1]);
  return Uint32Array.from(kept);
}

export class Path {
  constructor(scene, center) {
    this.scene = scene;
    this.group = new THREE.Group();
    this.levels = [];
    this.material = new THREE.ShaderMaterial({
      vertexShader, fragmentShader, transparent: true, side: THREE.DoubleSide, clipping: true,
      uniforms: {
        view: {value: new THREE.Vector2(1, 1)}, width: {value: 2.4}, head: {value: Infinity},
        chosen: {value: new THREE.Vector2(-1, -1)}, coloring: {value: 0}, palette: {value: []},
      },
    });
    let kept = keepAll(scene.count);
    for (const ratio of levelRatios) {
      if (ratio > 0 && this.levels.length && this.levels[this.levels.length - 1].kept.length < 4000) break;
      if (ratio > 0) kept = thin(scene, kept, ratio * scene.size);
      if (kept.length > 1) this.levels.push(this.level(kept, ratio, center));
    }
    this.show(0);
  }

  level(kept, ratio, center) {
    const n = kept.length, s = this.scene, data = new Float32Array(4 * n);
    for (let k = 0; k < n; ++k) {
      const i = kept[k];
      for (let a = 0; a < 3; ++a) data[4 * k + a] = s.places[3 * i + a] - center[a];
      data[4 * k + 3] = i;
    }
    const buffer = new THREE.InstancedInterleavedBuffer(data, 4, 1);
    const next = new THREE.InstancedInterleavedBuffer(data.subarray(4), 4, 1);
    const value = new THREE.InstancedBufferAttribute(new Float32Array(n - 1), 1);
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0], 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.setAttribute("a", new THREE.InterleavedBufferAttribute(buffer, 4, 0));
    geometry.setAttribute("b", new THREE.InterleavedBufferAttribute(next, 4, 0));
    geometry.setAttribute("value", value);
    geometry.instanceCount = n - 1;
    const mesh = new THREE.Mesh(geometry, this.material);
    mesh.frustumCulled = false;
    mesh.renderOrder = 2;
    this.group.add(mesh);
    return {kept, data, value, mesh, tolerance: ratio * s.size};
  }

  // `amounts` is nothing for the kinds, or a number from 0 to 1 for each location; NaN where there is none.
  paint(amounts) {
    this.material.uniforms.coloring.value = amounts ? 1 : 0;
    for (const level of this.levels) {
      const v = level.value.array;
      for (let k = 1; k < level.kept.length; ++k) {
        const i = level.kept[k], code = this.scene.kinds[i];
        const kind = (code & GUN) && (code & 15) !== START && (code & 15) !== 1 ? 4 : code & 15;
        const t = amounts ? amounts[i] : 0;
        v[k - 1] = kind + (Number.isNaN(t) ? 0 : 0.001 + 0.997 * Math.min(1, Math.max(0, t)));
      }
      level.value.needsUpdate = true;
    }
  }

  show(index) {
    this.shown = Math.min(index, this.levels.length - 1);
    this.levels.forEach((level, k) => { level.mesh.visible = k === this.shown; });
  }

  // The coarsest level whose errors stay below half a pixel, or a coarser one with no more than `most` places.
  adapt(unitsPerPixel, most) {
    let choice = 0;
    for (let k = 0; k < this.levels.length; ++k) if (this.levels[k].tolerance < 0.5 * unitsPerPixel) choice = k;
    while (choice + 1 < this.levels.length && this.levels[choice].kept.length > most) ++choice;
    if (choice !== this.shown) this.show(choice);
  }

  // The location whose move ends nearest to a place of the screen, within `reach` pixels, or -1.
  pick(camera, x, y, width, height, shows, reach = 9) {
    if (!this.levels.length) return -1;
    const level = this.levels[this.shown], m = new THREE.Matrix4(), place = new THREE.Vector3();
    m.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const e = m.elements, d = level.data;
    let best = reach * reach, found = -1, px = 0, py = 0, was = false;
    for (let k = 0; k < level.kept.length; ++k) {
      const X = d[4 * k], Y = d[4 * k + 1], Z = d[4 * k + 2];
      const w = e[3] * X + e[7] * Y + e[11] * Z + e[15];
      const qx = ((e[0] * X + e[4] * Y + e[8] * Z + e[12]) / w * 0.5 + 0.5) * width;
      const qy = (0.5 - (e[1] * X + e[5] * Y + e[9] * Z + e[13]) / w * 0.5) * height;
      if (was && w > 0 && (this.scene.kinds[level.kept[k]] & 15) !== START) {
        const ux = qx - px, uy = qy - py, length = ux * ux + uy * uy;
        const t = length > 0 ? Math.min(1, Math.max(0, ((x - px) * ux + (y - py) * uy) / length)) : 0;
        const ex = px + t * ux - x, ey = py + t * uy - y, distance = ex * ex + ey * ey;
        if (distance < best && shows(place.set(X, Y, Z))) { best = distance; found = k; this.share = t; this.pixels = Math.sqrt(length); }
      }
      px = qx; py = qy; was = w > 0;
    }
    if (found < 0) return -1;
    const a = level.kept[found - 1], b = level.kept[found];
    // Where on the move: its ends attract within the reach.
    const t = this.share * this.pixels < reach ? 0 : (1 - this.share) * this.pixels < reach ? 1 : this.share, p = this.scene.places;
    this.place = [0, 1, 2].map(k => (1 - t) * p[3 * a + k] + t * p[3 * b + k]);
    return Math.min(b, Math.max(a + 1, Math.round(a + this.share * (b - a) + 0.5)));
  }
}
