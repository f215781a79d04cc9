// The tool path as ribbons of constant width on the screen, in levels of detail that were found when the page was written
// (backend/html/detail.h): of the blocks in sight, the locations of the level that a pixel can show go to the screen.
import * as THREE from "three";
import {Sight} from "./sight.js";
import {number, GUN, START} from "./data.js";

const vertexShader = `
attribute vec4 a; attribute vec4 b; attribute float value; attribute float corner;
uniform vec2 view; uniform float width; uniform float head; uniform vec2 chosen; uniform vec3 palette[6]; uniform float coloring; uniform vec2 relief;
varying vec3 ink; varying float fade; varying vec3 world;
#include <clipping_planes_pars_vertex>
vec3 ramp(float t) {
  t = clamp(t, 0.0, 1.0);
  vec3 low = vec3(0.13, 0.40, 0.80), middle = vec3(0.16, 0.65, 0.35), high = vec3(0.85, 0.15, 0.12), yellow = vec3(0.93, 0.72, 0.10);
  return t < 0.34 ? mix(low, middle, t / 0.34) : t < 0.67 ? mix(middle, yellow, (t - 0.34) / 0.33) : mix(yellow, high, (t - 0.67) / 0.33);
}
void main() {
  vec2 side_ = vec2(floor(corner * 0.5), mod(corner, 2.0) * 2.0 - 1.0); // end of the move, side of the ribbon
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
  vec2 side = vec2(-along.y, along.x) * side_.y * half_ + along * (side_.x - 0.5) * half_;
  vec4 end = side_.x < 0.5 ? p : q;
  end.xy += side / view * 2.0 * end.w;
  end.z -= (marked ? 2e-4 : 5e-5) * end.w;
  ink = coloring > 0.5 ? (amount < 0.0005 ? palette[5] : ramp((amount - 0.001) / 0.997)) : palette[int(kind)];
  if (relief.y > 0.0 && coloring < 0.5) { // a dense path is seen as a surface: lower places and steep moves are darker
    vec3 d = b.xyz - a.xyz;
    float steep = d.z * d.z / max(dot(d, d), 1e-30), height = clamp(0.5 + ((side_.x < 0.5 ? a.z : b.z) - relief.x) / relief.y, 0.0, 1.0);
    ink *= (0.65 + 0.5 * height) * (1.0 - 0.4 * steep);
  }
  if (marked) ink = palette[0];
  fade = index > head ? 0.38 : 1.0;
  if (kind == 0.0) end = vec4(2.0, 2.0, 2.0, 1.0);
  vec4 mvPosition = modelViewMatrix * vec4(side_.x < 0.5 ? a.xyz : b.xyz, 1.0);
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

const wide = 10; // numbers a vertex: both ends of the move with the location at the end, value, corner

const reliefFrom = 50000; // locations

// The mean height and four standard deviations of a long path; 0 for a short one.
function heights(scene, middle) {
  if (scene.count < reliefFrom) return new THREE.Vector2(0, 0);
  let sum = 0, squares = 0;
  for (let i = 2; i < scene.places.length; i += 3) { const z = scene.places[i] - middle; sum += z; squares += z * z; }
  const mean = sum / scene.count;
  return new THREE.Vector2(mean, 4 * Math.sqrt(Math.max(0, squares / scene.count - mean * mean)));
}

export class Path {
  constructor(scene, center) {
    this.scene = scene;
    this.center = center;
    this.group = new THREE.Group();
    this.material = new THREE.ShaderMaterial({
      vertexShader, fragmentShader, transparent: true, side: THREE.DoubleSide, clipping: true,
      uniforms: {
        view: {value: new THREE.Vector2(1, 1)}, width: {value: 2.4}, head: {value: Infinity},
        chosen: {value: new THREE.Vector2(-1, -1)}, coloring: {value: 0}, palette: {value: []},
        relief: {value: heights(scene, center[2])},
      },
    });
    this.blocks = scene.boxes.length / 6;
    this.highest = scene.tolerances.length - 1;
    this.count();
    this.amounts = null;
    this.thinned = "";
    this.drawn = 0;
    this.room = 0;
    this.key = this.viewed = ""; // what was gathered; for which view, if it was cut to it
    this.has = new Uint8Array(this.blocks);
  }

  // counts[level * blocks + block]: the moves that a block has in a level.
  count() {
    const s = this.scene, n = this.blocks;
    this.counts = new Uint32Array((this.highest + 1) * n);
    for (let i = 1; i < s.count; ++i) ++this.counts[s.levels[i] * n + Math.floor((i - 1) / s.block)];
    for (let k = this.highest * n - 1; k >= 0; --k) this.counts[k] += this.counts[k + n];
  }

  // The places of each level, of the whole path.
  totals() {
    const totals = [];
    for (let level = 0; level <= this.highest; ++level) totals.push(this.total(level, null) + 1);
    return totals;
  }

  total(level, inSight) {
    let sum = 0;
    for (let b = 0; b < this.blocks; ++b) if (!inSight || inSight[b]) sum += this.counts[level * this.blocks + b];
    return sum;
  }

  // `amounts` is nothing for the kinds, or a number from 0 to 1 for each location; NaN where there is none.
  paint(amounts) {
    this.material.uniforms.coloring.value = amounts ? 1 : 0;
    this.amounts = amounts;
    this.key = this.viewed = "";
  }

  // Takes the coarsest level whose errors stay below half a pixel, or a coarser one with no more than `most` moves in sight.
  // What was taken serves until the view leaves it.
  adapt(camera, unitsPerPixel, most) {
    if (this.scene.count < 2) return;
    const sight = new Sight(camera, this.scene, this.center), seen = sight.blocks(1);
    let level = 0;
    while (level < this.highest && this.scene.tolerances[level + 1] < 0.5 * unitsPerPixel) ++level;
    let total = this.total(level, seen), share = 1;
    const clipped = total > most ? sight : null; // boxes are larger than what they hold
    if (clipped) {
      if (clipped.key === this.viewed && most > 0.5 * this.allowed && most < 2 * this.allowed) return;
      this.has = seen;
      const inSight = this.tally(level, 1, clipped);
      share = inSight / total;
      total = inSight;
    }
    this.coarse = total > most;
    while (level < this.highest && total > most) {
      const next = share * this.total(level + 1, seen);
      if (next < most / 16) break; // nearly all would be gone, as of a field of holes: some of the moves tell more
      total = next;
      ++level;
    }
    const every = Math.max(1, Math.ceil(total / (1.5 * most))), key = level + "/" + every;
    if (!clipped && !this.viewed && key === this.key && seen.every((v, b) => !v || this.has[b])) return;
    const more = sight.blocks(1.6);
    this.has = !clipped && this.total(level, more) <= most ? more : seen;
    this.viewed = clipped ? clipped.key : "";
    this.allowed = most;
    this.key = key;
    this.gather(level, every, clipped);
  }

  reserve(moves) {
    if (this.buffer && moves <= this.room) return;
    this.room = Math.ceil(1.3 * moves) + 64;
    this.data = new Float32Array(4 * wide * this.room);
    this.buffer = new THREE.InterleavedBuffer(this.data, wide).setUsage(THREE.DynamicDrawUsage);
    const corners = new Uint32Array(6 * this.room);
    for (let k = 0, o = 0; k < this.room; ++k) for (const c of [0, 1, 2, 2, 1, 3]) corners[o++] = 4 * k + c;
    const geometry = new THREE.BufferGeometry(), part = (size, at) => new THREE.InterleavedBufferAttribute(this.buffer, size, at);
    geometry.setAttribute("a", part(4, 0));
    geometry.setAttribute("b", part(4, 4));
    geometry.setAttribute("value", part(1, 8));
    geometry.setAttribute("corner", part(1, 9));
    geometry.setIndex(new THREE.BufferAttribute(corners, 1));
    if (this.mesh) { this.mesh.geometry.dispose(); this.group.remove(this.mesh); }
    this.mesh = new THREE.Mesh(geometry, this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
    this.group.add(this.mesh);
  }

  // Hands out the moves of a level in the blocks at hand, and in sight if that is given; of a path that no level makes short
  // enough, every so many.
  each(level, every, sight, take) {
    const s = this.scene;
    for (let b = 0, left = 0; b < this.blocks; ++b) {
      if (!this.has[b]) continue;
      let from = b * s.block;
      const last = Math.min(from + s.block, s.count - 1);
      for (let i = from + 1; i <= last; ++i) {
        if (s.levels[i] < level) continue;
        if ((s.kinds[i] & 15) !== START && (!sight || sight.meets(from, i))) {
          if (++left % every !== 0 && i < last && (s.kinds[i + 1] & 15) !== START) continue;
          take(from, i);
        }
        from = i;
      }
    }
  }

  tally(level, every, sight) {
    let moves = 0;
    this.each(level, every, sight, () => { ++moves; });
    return moves;
  }

  gather(level, every, sight) {
    this.thinned = every > 1 ? `1 of ${every} places drawn` : this.coarse ? `drawn to within ${number(this.scene.tolerances[level], 2)} ${this.scene.unit}` : "";
    this.reserve(this.tally(level, every, sight));
    this.drawn = 0;
    this.each(level, every, sight, (from, to) => this.add(from, to));
    this.buffer.clearUpdateRanges();
    this.buffer.addUpdateRange(0, 4 * wide * this.drawn);
    this.buffer.needsUpdate = true;
    this.mesh.geometry.setDrawRange(0, 6 * this.drawn);
  }

  add(from, to) {
    const d = this.data, p = this.scene.places, c = this.center, code = this.scene.kinds[to];
    const kind = (code & GUN) && (code & 15) !== START && (code & 15) !== 1 ? 4 : code & 15;
    const t = this.amounts ? this.amounts[to] : 0, value = kind + (Number.isNaN(t) ? 0 : 0.001 + 0.997 * Math.min(1, Math.max(0, t)));
    let o = 4 * wide * this.drawn++;
    for (let corner = 0; corner < 4; ++corner, o += wide) {
      for (let a = 0; a < 3; ++a) {
        d[o + a] = p[3 * from + a] - c[a];
        d[o + 4 + a] = p[3 * to + a] - c[a];
      }
      d[o + 3] = from;
      d[o + 7] = to;
      d[o + 8] = value;
      d[o + 9] = corner;
    }
  }

  // The location whose move ends nearest to a place of the screen, within `reach` pixels, or -1: first among the moves that are
  // drawn, then among those that the nearest one stands for.
  pick(camera, x, y, width, height, shows, reach = 9) {
    const e = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements, at = new THREE.Vector3();
    const p = this.scene.places, c = this.center, ends = [0, 0, 0, 0];
    const put = (i, k) => {
      const X = p[3 * i] - c[0], Y = p[3 * i + 1] - c[1], Z = p[3 * i + 2] - c[2];
      ends[k] = ((e[0] * X + e[4] * Y + e[8] * Z + e[12]) * 0.5 + 0.5) * width;
      ends[k + 1] = (0.5 - (e[1] * X + e[5] * Y + e[9] * Z + e[13]) * 0.5) * height;
    };
    let best = reach * reach, found = null;
    const look = (from, to) => {
      put(from, 0);
      put(to, 2);
      const ux = ends[2] - ends[0], uy = ends[3] - ends[1], length = ux * ux + uy * uy;
      const t = length > 0 ? Math.min(1, Math.max(0, ((x - ends[0]) * ux + (y - ends[1]) * uy) / length)) : 0;
      const ex = ends[0] + t * ux - x, ey = ends[1] + t * uy - y, distance = ex * ex + ey * ey;
      if (distance >= best || !shows(at.set(...[0, 1, 2].map(a => (1 - t) * p[3 * from + a] + t * p[3 * to + a] - c[a])))) return;
      best = distance;
      found = {from, to, t, pixels: Math.sqrt(length)};
    };
    for (let k = 0; k < this.drawn; ++k) look(this.data[4 * wide * k + 3], this.data[4 * wide * k + 7]);
    if (!found) return -1;
    const {from, to} = found;
    best = Infinity;
    for (let i = from + 1; i <= to; ++i) if ((this.scene.kinds[i] & 15) !== START) look(i - 1, i);
    // Where on the move: its ends attract within the reach.
    const share = found.t * found.pixels < reach ? 0 : (1 - found.t) * found.pixels < reach ? 1 : found.t;
    this.place = [0, 1, 2].map(a => (1 - share) * p[3 * found.from + a] + share * p[3 * found.to + a]);
    return found.to;
  }
}
