// What stands beside the path: named geometry as lines, shaded surfaces, films, the tool.
import * as THREE from "three";
import {GUN} from "./data.js";

const wire = (points, material) => new THREE.Line(new THREE.BufferGeometry().setFromPoints(points), material);

function ring(center, axis, radius, material) {
  const points = [], z = axis.clone().normalize();
  const x = Math.abs(z.z) < 0.9 ? new THREE.Vector3(0, 0, 1).cross(z).normalize() : new THREE.Vector3(1, 0, 0).addScaledVector(z, -z.x).normalize();
  const y = z.clone().cross(x);
  for (let i = 0; i <= 96; ++i) {
    const t = i / 96 * 2 * Math.PI;
    points.push(center.clone().addScaledVector(x, radius * Math.cos(t)).addScaledVector(y, radius * Math.sin(t)));
  }
  return wire(points, material);
}

// Lines of the named entities near the path, and where their names stand. Sizes beyond the box are cut to it.
export function drawEntities(scene, center, material) {
  const group = new THREE.Group(), labels = [], reach = 0.62 * scene.size;
  const middle = new THREE.Vector3(...[0, 1, 2].map(a => (scene.low[a] + scene.high[a]) / 2 - center[a]));
  const at = (c, k = 0) => new THREE.Vector3(c[k] - center[0], c[k + 1] - center[1], c[k + 2] - center[2]);
  const floor = scene.low[2] - center[2];
  const near = p => p.distanceTo(middle) < 1.6 * reach;
  const label = (name, p, ...others) => { if (near(p) && labels.length < 250) labels.push({name, place: p, others}); };
  for (const e of scene.entities.slice(0, 2000)) {
    const c = e.canon;
    (e.curves || []).forEach((curve, n) => {
      const points = [];
      for (let k = 0; k < curve.length; k += 3) points.push(at(curve, k));
      group.add(wire(points, material));
      if (points.length && n === 0) label(e.name, points[Math.floor(points.length / 3)]);
    });
    if (e.type === "POINT") {
      const p = at(c), d = 0.007 * scene.size;
      if (!near(p)) continue;
      group.add(wire([p.clone().add(new THREE.Vector3(-d, 0, 0)), p.clone().add(new THREE.Vector3(d, 0, 0))], material));
      group.add(wire([p.clone().add(new THREE.Vector3(0, -d, 0)), p.clone().add(new THREE.Vector3(0, d, 0))], material));
      label(e.name, p);
    } else if (e.type === "LINE") {
      const n = new THREE.Vector3(c[0], c[1], 0), along = new THREE.Vector3(-c[1], c[0], 0);
      const foot = n.clone().multiplyScalar(c[3]).sub(new THREE.Vector3(center[0], center[1], 0));
      foot.addScaledVector(along, middle.clone().sub(foot).dot(along)).setZ(floor);
      if (Math.hypot(foot.x - middle.x, foot.y - middle.y) > reach) continue;
      group.add(wire([foot.clone().addScaledVector(along, -reach), foot.clone().addScaledVector(along, reach)], material));
      label(e.name, ...[0.8, -0.8, 0.55, -0.55, 0.42, -0.42, 0.3, -0.3].map(t => foot.clone().addScaledVector(along, t * reach)));
    } else if (e.type === "CIRCLE") {
      const p = at(c).setZ(floor);
      if (c[6] > 3 * scene.size) continue;
      group.add(ring(p, new THREE.Vector3(0, 0, 1), c[6], material));
      label(e.name, ...[[1, 1], [1, -1], [-1, 1], [-1, -1]].map(([x, y]) => p.clone().add(new THREE.Vector3(x * c[6] * 0.71, y * c[6] * 0.71, 0))));
    } else if (e.type === "SPHERE" && c[3] < 3 * scene.size) {
      for (const axis of [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) group.add(ring(at(c), new THREE.Vector3(...axis), c[3], material));
      label(e.name, at(c).add(new THREE.Vector3(0, 0, c[3])));
    } else if (e.type === "CYLNDR" && c[6] < 3 * scene.size) {
      const axis = new THREE.Vector3(c[3], c[4], c[5]), p = at(c);
      p.addScaledVector(axis, middle.clone().sub(p).dot(axis));
      for (const t of [-0.5, 0, 0.5]) group.add(ring(p.clone().addScaledVector(axis, t * reach), axis, c[6], material));
      label(e.name, p);
    } else if (e.type === "PATERN") {
      for (let k = 0; k + 2 < c.length; k += 3) group.add(ring(at(c, k), new THREE.Vector3(0, 0, 1), 0.006 * scene.size, material));
      label(e.name, at(c));
    }
  }
  labelSurfaces(scene, center, labels);
  return {group, labels};
}

// Where motions are missing: their lines, and the way of the next motion, which does not begin where the program meant.
export function drawFaults(scene, center, labels) {
  const group = new THREE.Group(), material = new THREE.LineDashedMaterial({color: 0xffd33d, dashSize: 0.008 * scene.size, gapSize: 0.008 * scene.size, depthTest: false, transparent: true});
  const at = p => new THREE.Vector3(...p.map((v, a) => v - center[a]));
  for (const f of scene.faults) {
    const line = wire([at(f.place), at(f.next)], material).computeLineDistances();
    line.renderOrder = 4;
    group.add(line);
    labels.push({name: `\u2716 line ${f.line}`, place: at(f.place), wrong: true});
  }
  return group;
}

// The names of surfaces that have no lines: at their highest place in the box.
function labelSurfaces(scene, center, labels) {
  for (const m of scene.meshes) {
    if (m.auxiliary || labels.some(l => l.name === m.name)) continue;
    let best = -Infinity, place = null;
    const places = partOf(scene, m) ? partOf(scene, m).places : m.places;
    for (let k = 0; k < places.length; k += 3) {
      const p = places.subarray(k, k + 3), inside = [0, 1, 2].every(a => p[a] >= scene.box[2 * a] && p[a] <= scene.box[2 * a + 1]) || places !== m.places;
      const height = 3 * p[2] + p[0] - p[1];
      if (inside && height > best) { best = height; place = p; }
    }
    if (place) labels.push({name: m.name, place: new THREE.Vector3(place[0] - center[0], place[1] - center[1], place[2] - center[2])});
  }
}

const surfaceInks = [0x7aa6d8, 0x9cc59a, 0xd9b779, 0xc39ad0, 0x8fcacb, 0xd99a93];

// The sides of the box in which surfaces are shown: they go on without end.
function sidesOf(scene, center) {
  const planes = [];
  for (let a = 0; a < 3 && scene.box.length === 6; ++a) {
    const normal = new THREE.Vector3().setComponent(a, 1);
    planes.push(new THREE.Plane(normal.clone(), -(scene.box[2 * a] - center[a])), new THREE.Plane(normal.negate(), scene.box[2 * a + 1] - center[a]));
  }
  return planes;
}

// Those that have a name or are part surfaces, or the others.
export function drawSurfaces(scene, center, auxiliary) {
  const group = new THREE.Group(), sides = sidesOf(scene, center);
  const shown = scene.meshes.filter(m => !m.auxiliary).length;
  scene.meshes.forEach((m, i) => {
    if (m.auxiliary !== auxiliary) return;
    const color = surfaceInks[i % surfaceInks.length], flat = partOf(scene, m);
    const places = (flat || m).places.slice();
    for (let k = 0; k < places.length; ++k) places[k] -= center[k % 3];
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(places, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(flat ? flat.normals : m.normals, 3));
    geometry.setIndex(new THREE.BufferAttribute(flat ? flat.triangles : m.triangles, 1));
    const opacity = Math.max(flat ? 0.02 : 0.05, (flat ? 0.24 : 0.36) * Math.min(1, 5 / Math.max(1, shown))); // many would hide the path
    const mesh = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({
      color, side: THREE.DoubleSide, transparent: true, opacity, roughness: 0.62,
      metalness: 0.05, depthWrite: false, clippingPlanes: sides,
    }));
    mesh.userData.sides = sides;
    mesh.name = m.name;
    group.add(mesh);
    if (flat) {
      const corners = [0, 1, 2, 3].map(k => new THREE.Vector3().fromArray(places, 3 * k));
      const outline = new THREE.LineLoop(new THREE.BufferGeometry().setFromPoints(corners), new THREE.LineBasicMaterial({color, transparent: true, opacity: 0.7, clippingPlanes: sides}));
      outline.userData.sides = sides;
      group.add(outline);
    }
  });
  return group;
}

function partOf(scene, m) {
  if (m.part === undefined) m.part = flatPart(scene, m);
  return m.part;
}

const flatness = 1e-5; // of normals
const most = 20000; // locations that are looked at

// Of a plane only the part where the path runs near it is shown, with an outline: planes go on for ever, and dozens of them
// hide everything. Nothing of a surface that is not flat, or that the path does not come near.
function flatPart(scene, m) {
  const n = new THREE.Vector3(m.normals[0], m.normals[1], m.normals[2]).normalize(), v = new THREE.Vector3();
  for (let k = 0; k < m.normals.length; k += 3) if (1 - Math.abs(v.fromArray(m.normals, k).normalize().dot(n)) > flatness) return null;
  const first = new THREE.Vector3().fromArray(m.places, 0), along = new THREE.Vector3(0, 0, 1).cross(n);
  if (along.lengthSq() < 1e-6) along.set(1, 0, 0);
  along.normalize();
  const up = n.clone().cross(along), reach = 0.02 * scene.extent + 0.55 * scene.cutters.reduce((a, c) => Math.max(a, c.diameter), 0);
  const rims = () => [Infinity, -Infinity, Infinity, -Infinity];
  const take = (r, p) => {
    const x = p.dot(along), y = p.dot(up);
    r[0] = Math.min(r[0], x); r[1] = Math.max(r[1], x); r[2] = Math.min(r[2], y); r[3] = Math.max(r[3], y);
  };
  const near = rims(), whole = rims(), step = Math.max(1, Math.floor(scene.count / most));
  for (let i = 0; i < scene.count; i += step) {
    v.fromArray(scene.places, 3 * i).sub(first);
    if (Math.abs(v.dot(n)) <= reach) take(near, v);
  }
  for (let k = 0; k < m.places.length; k += 3) take(whole, v.fromArray(m.places, k).sub(first));
  if (!(near[0] <= near[1])) return null;
  const margin = 0.04 * scene.size, r = [Math.max(near[0] - margin, whole[0]), Math.min(near[1] + margin, whole[1]), Math.max(near[2] - margin, whole[2]), Math.min(near[3] + margin, whole[3])];
  if (!(r[0] < r[1] && r[2] < r[3])) return null;
  const places = new Float32Array(12), normals = new Float32Array(12);
  [[0, 2], [1, 2], [1, 3], [0, 3]].forEach(([x, y], k) => {
    first.clone().addScaledVector(along, r[x]).addScaledVector(up, r[y]).toArray(places, 3 * k);
    n.toArray(normals, 3 * k);
  });
  return {places, normals, triangles: new Uint32Array([0, 1, 2, 0, 2, 3])};
}

// Blue is too thin, green right, red too thick; white is no film.
export function filmColor(film, wanted, color = new THREE.Color()) {
  const t = film / wanted;
  if (!(t > 0.02)) return color.setRGB(0.92, 0.92, 0.92);
  const hue = t < 1 ? 0.62 - 0.28 * Math.max(0, (t - 0.5) / 0.5) : 0.34 - 0.34 * Math.min(1, (t - 1) / 0.5);
  return color.setHSL(hue, 0.72, 0.5);
}

export function drawFilms(scene, center) {
  const group = new THREE.Group(), color = new THREE.Color();
  for (const f of scene.films) {
    const places = [], inks = [], values = [], columns = f.columns, wide = columns + 1;
    for (let q = 0; f.strips && q < f.film.length; q += 4) for (const k of [q, q + 1, q + 2, q, q + 2, q + 3]) { // two triangles
      for (let a = 0; a < 3; ++a) places.push(f.corners[3 * k + a] - center[a]);
      filmColor(f.film[k], f.wanted, color);
      inks.push(color.r, color.g, color.b);
      if (k === q) values.push(f.film[k]);
    }
    for (let r = 0; r < f.rows; ++r) for (let c = 0; c < columns; ++c) {
      const film = f.film[r * columns + c];
      if (Number.isNaN(film)) continue;
      values.push(film, film);
      filmColor(film, f.wanted, color);
      const corner = (dc, dr) => 3 * ((r + dr) * wide + c + dc);
      for (const k of [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 0), corner(1, 1), corner(0, 1)]) {
        for (let a = 0; a < 3; ++a) places.push(f.corners[k + a] - center[a]);
        inks.push(color.r, color.g, color.b);
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(places, 3));
    geometry.setAttribute("color", new THREE.Float32BufferAttribute(inks, 3));
    const mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({vertexColors: true, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2}));
    mesh.name = f.name;
    mesh.userData.film = {wanted: f.wanted, relative: f.relative, values}; // of each triangle
    group.add(mesh);
  }
  return group;
}

// A cutter of diameter and corner radius, or a spray gun with its cone; the tool end at the origin, the axis along z.
export class Tool {
  constructor(scene) {
    this.scene = scene;
    this.group = new THREE.Group();
    this.material = new THREE.MeshStandardMaterial({color: 0xd8a03a, metalness: 0.35, roughness: 0.4, transparent: true, opacity: 0.72});
    this.spray = new THREE.MeshBasicMaterial({color: 0xb5179e, transparent: true, opacity: 0.28, side: THREE.DoubleSide, depthWrite: false});
    this.cutter = null;
  }

  build(cutter) {
    this.cutter = cutter;
    this.group.clear();
    const s = this.scene;
    if (s.gunStandOff > 0 || (!cutter && s.kinds.some(k => k & GUN))) {
      const size = Math.max(0.1 * s.gunStandOff, 0.012 * s.size);
      const body = new THREE.Mesh(new THREE.CylinderGeometry(size * 0.5, size * 0.22, 2.4 * size, 24), this.material);
      body.rotation.x = Math.PI / 2;
      body.position.z = 1.2 * size;
      this.group.add(body);
      if (!(s.gunStandOff > 0)) return;
      this.cone = new THREE.Mesh(new THREE.ConeGeometry(s.gunRadius, s.gunStandOff, 40, 1, true), this.spray);
      this.cone.rotation.x = Math.PI / 2;
      this.cone.position.z = -0.5 * s.gunStandOff;
      this.group.add(this.cone);
      return;
    }
    const r = cutter && cutter.diameter > 0 ? cutter.diameter / 2 : 0.006 * s.size, corner = cutter ? Math.min(cutter.corner, r) : 0;
    const height = Math.max(3 * r, 0.12 * s.size), profile = [new THREE.Vector2(0, 0), new THREE.Vector2(r - corner, 0)];
    for (let i = 1; i <= 12 && corner > 0; ++i) {
      const t = i / 12 * Math.PI / 2;
      profile.push(new THREE.Vector2(r - corner + corner * Math.sin(t), corner - corner * Math.cos(t)));
    }
    profile.push(new THREE.Vector2(r, height), new THREE.Vector2(0, height));
    const body = new THREE.Mesh(new THREE.LatheGeometry(profile, 48), this.material);
    body.rotation.x = Math.PI / 2;
    this.group.add(body);
  }

  put(place, axis, index, gun) {
    const cutters = this.scene.cutters;
    let use = cutters.length ? cutters[0] : null;
    for (const c of cutters) if (c.first <= index) use = c;
    if (this.group.children.length === 0 || use !== this.cutter) this.build(use);
    if (this.cone) this.cone.visible = gun;
    this.group.position.copy(place);
    this.group.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), axis);
  }
}
