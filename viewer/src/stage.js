// The three-dimensional view: camera, lights, section plane, labels, and what a place of the screen is.
import * as THREE from "three";
import {OrbitControls} from "three/addons/controls/OrbitControls.js";
import {drawEntities, drawFaults, drawSurfaces, drawFilms, Tool} from "./things.js";
import {Path} from "./path.js";
import {visible} from "./source.js";
import {Speed} from "./speed.js";

const palettes = {
  light: ["#ff7a00", "#d1242f", "#1f5fbf", "#0a8f6c", "#b5179e", "#9aa3ad"],
  dark: ["#ffb020", "#ff7a4d", "#6cb2ff", "#3ddc97", "#d58bff", "#5c6672"],
};
export const viewNames = {plan: [0, 0, 1], front: [0, -1, 0], side: [1, 0, 0], iso: [0.62, -0.72, 0.55]};

const mostPatience = 8;

export class Stage {
  constructor(scene) {
    this.data = scene;
    this.canvas = document.getElementById("canvas");
    this.center = [0, 1, 2].map(a => (scene.low[a] + scene.high[a]) / 2);
    this.speed = new Speed();
    this.patience = 1;
    const smooth = !(this.speed.software && scene.count > 30000); // four samples a pixel take three times as long there
    this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, antialias: smooth, preserveDrawingBuffer: true});
    this.renderer.localClippingEnabled = true;
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    this.world = new THREE.Scene();
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -1e3 * scene.size, 1e3 * scene.size);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => this.moved());
    const sun = new THREE.DirectionalLight(0xffffff, 1.9);
    sun.position.set(0.5, -0.7, 1);
    this.world.add(new THREE.HemisphereLight(0xffffff, 0x8899aa, 1.6), sun);
    this.wireMaterial = new THREE.LineBasicMaterial({transparent: true, opacity: 0.75});
    const {group, labels} = drawEntities(scene, this.center, this.wireMaterial);
    this.layers = {
      path: (this.path = new Path(scene, this.center)).group, surfaces: drawSurfaces(scene, this.center, false),
      unnamed: drawSurfaces(scene, this.center, true),
      film: drawFilms(scene, this.center), geometry: group, tool: (this.tool = new Tool(scene)).group,
    };
    this.world.add(drawFaults(scene, this.center, labels));
    labels.sort((a, b) => Boolean(b.wrong) - Boolean(a.wrong)); // those come first where there is little room
    this.labels = labels.map(l => Object.assign(l, {element: document.createElement("span")}));
    for (const l of this.labels) { l.element.textContent = visible(l.name); l.element.classList.toggle("wrong", Boolean(l.wrong)); document.getElementById("labels").append(l.element); }
    this.layers.unnamed.visible = this.layers.unnamed.children.length < 7; // nested planes of a loop would hide the rest
    for (const layer of Object.values(this.layers)) this.world.add(layer);
    this.marks = new THREE.Group();
    this.world.add(this.marks);
    this.plane = new THREE.Plane(new THREE.Vector3(0, 0, -1), 0);
    new ResizeObserver(() => this.resize()).observe(this.canvas.parentElement);
    this.dark(false);
    this.resize();
    this.look(scene.high[2] - scene.low[2] < 1e-6 * scene.size && !scene.films.length ? "plan" : "iso");
  }

  dark(on) {
    this.isDark = on;
    document.documentElement.classList.toggle("dark", on);
    this.world.background = new THREE.Color(on ? 0x14181d : 0xfbfbfa);
    this.wireMaterial.color.set(on ? 0x8593a3 : 0x7b8794);
    this.colors = palettes[on ? "dark" : "light"];
    // The path is drawn without lights: its colors go to the screen as they are.
    this.path.material.uniforms.palette.value = this.colors.map(c => { const v = new THREE.Color(c).getRGB({}, THREE.SRGBColorSpace); return new THREE.Vector3(v.r, v.g, v.b); });
    this.request();
  }

  look(name) {
    const d = new THREE.Vector3(...viewNames[name]).normalize(), s = this.data;
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(d.clone().multiplyScalar(2 * s.size));
    this.camera.up.set(0, name === "plan" ? 1 : 0, name === "plan" ? 0 : 1);
    this.camera.lookAt(0, 0, 0);
    this.camera.up.set(0, 0, 1);
    if (name === "plan") { this.camera.position.y -= 1e-4 * s.size; }
    this.camera.updateMatrixWorld(true);
    const inverse = this.camera.matrixWorldInverse.copy(this.camera.matrixWorld).invert();
    let w = 1e-9, h = 1e-9;
    for (let i = 0; i < 8; ++i) {
      const p = new THREE.Vector3(...[0, 1, 2].map(a => (i >> a & 1 ? s.high[a] : s.low[a]) - this.center[a])).applyMatrix4(inverse);
      w = Math.max(w, Math.abs(p.x));
      h = Math.max(h, Math.abs(p.y));
    }
    const aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
    this.half = 1.22 * Math.max(h, w / aspect, 0.02 * s.size);
    this.camera.zoom = 1;
    this.resize();
    this.controls.update();
  }

  resize() {
    const box = this.canvas.parentElement, w = Math.max(1, box.clientWidth), h = Math.max(1, box.clientHeight);
    this.renderer.setSize(w, h, false);
    const half = this.half || 1;
    Object.assign(this.camera, {left: -half * w / h, right: half * w / h, top: half, bottom: -half});
    this.camera.updateProjectionMatrix();
    this.path.material.uniforms.view.value.set(w, h);
    this.request();
  }

  unitsPerPixel() { return 2 * (this.half || 1) / this.camera.zoom / Math.max(1, this.canvas.clientHeight); }

  section(axis, share, flip, on) {
    const a = "xyz".indexOf(axis), s = this.data, place = s.low[a] + share * (s.high[a] - s.low[a]) - this.center[a];
    this.plane.normal.set(0, 0, 0).setComponent(a, flip ? 1 : -1);
    this.plane.constant = flip ? -place : place;
    const planes = on ? [this.plane] : [];
    this.cutting = on;
    for (const layer of [this.layers.path, this.layers.surfaces, this.layers.unnamed, this.layers.film, this.layers.geometry]) {
      layer.traverse(o => { if (o.material) o.material.clippingPlanes = [...(o.userData.sides || []), ...planes]; });
    }
    this.request();
    return place + this.center[a];
  }

  // Whether the section leaves a place of the view's space.
  shows(place, sides = []) {
    return (!this.cutting || this.plane.distanceToPoint(place) >= 0) && sides.every(s => s.distanceToPoint(place) >= 0);
  }

  // A mark at each measured place and a line between two.
  measure(places) {
    this.marks.clear();
    const points = places.map(p => new THREE.Vector3(...p.map((v, a) => v - this.center[a])));
    const material = new THREE.LineBasicMaterial({color: 0xff7a00, depthTest: false});
    for (const p of points) {
      const ball = new THREE.Mesh(new THREE.SphereGeometry(4 * this.unitsPerPixel(), 16, 12), new THREE.MeshBasicMaterial({color: 0xff7a00, depthTest: false}));
      ball.position.copy(p);
      ball.renderOrder = 5;
      this.marks.add(ball);
    }
    if (points.length > 1) {
      const line = new THREE.Line(new THREE.BufferGeometry().setFromPoints(points), material);
      line.renderOrder = 5;
      this.marks.add(line);
    }
    this.request();
  }

  // What is under a place of the screen: the nearest location of the path, else a place of a surface.
  under(x, y) {
    const w = this.canvas.clientWidth, h = this.canvas.clientHeight, index = this.layers.path.visible ? this.path.pick(this.camera, x, y, w, h, p => this.shows(p)) : -1;
    if (index >= 0) return {index, place: this.path.place};
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2(2 * x / w - 1, 1 - 2 * y / h), this.camera);
    const solid = [this.layers.surfaces, this.layers.unnamed, this.layers.film].filter(l => l.visible).flatMap(l => l.children.filter(o => o.isMesh));
    const hit = ray.intersectObjects(solid, false).find(h => this.shows(h.point, h.object.userData.sides));
    if (!hit) return null;
    const film = hit.object.userData.film;
    return {
      index: -1, name: hit.object.name, place: hit.point.toArray().map((v, a) => v + this.center[a]),
      film: film ? {value: film.values[hit.faceIndex], wanted: film.wanted, relative: film.relative} : null,
    };
  }

  // While the view moves fewer moves of the path are drawn; once it rests, more and more, as long as it pays.
  moved() {
    this.moving = true;
    this.patience = 1;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => { this.moving = false; this.request(); }, 250);
    this.request();
  }

  // One picture at a time: while the graphics work on one, requests are put together to one more.
  request() {
    if (this.asked) return;
    this.asked = true;
    const turn = () => {
      if (!this.speed.ready(this.renderer.getContext())) { requestAnimationFrame(turn); return; }
      this.asked = false;
      this.render();
    };
    requestAnimationFrame(turn);
  }

  render() {
    const busy = Boolean(this.moving || this.playing);
    this.path.adapt(this.camera, this.unitsPerPixel(), this.speed.most(busy, this.patience));
    this.speed.begin(this.layers.path.visible ? this.path.drawn : 0);
    this.renderer.render(this.world, this.camera);
    this.speed.end(this.renderer.getContext());
    if (this.path.coarse && !busy && this.patience < mostPatience) {
      clearTimeout(this.rest);
      this.rest = setTimeout(() => { this.patience *= 2; this.request(); }, 100);
    }
    this.writeLabels();
    if (this.afterRender) this.afterRender();
  }

  // Each name at the first of its places that is in sight, not behind a panel and not taken by another name.
  writeLabels() {
    const w = this.canvas.clientWidth, h = this.canvas.clientHeight, taken = [];
    for (const id of ["layers", "readout", "cut"]) {
      const e = document.getElementById(id);
      if (e.offsetWidth) taken.push({x: e.offsetLeft + e.offsetWidth / 2, y: e.offsetTop + e.offsetHeight / 2 + 7, wide: e.offsetWidth, tall: e.offsetHeight});
    }
    const room = (place, wide) => {
      const p = place.clone().project(this.camera), x = (p.x * 0.5 + 0.5) * w, y = (0.5 - p.y * 0.5) * h;
      const free = this.shows(place) && x > 0 && x < w && y > 12 && y < h &&
        !taken.some(t => Math.abs(t.x - x) < (t.wide + wide) / 2 && Math.abs(t.y - y) < (t.tall + 14) / 2);
      return free ? {x, y, wide, tall: 14} : null;
    };
    for (const l of this.labels) {
      const wide = 6.5 * l.name.length + 6;
      let at = null;
      if (l.wrong || this.layers.geometry.visible) for (const place of [l.place, ...(l.others || [])]) if (!at) at = room(place, wide);
      l.element.style.display = at ? "" : "none";
      if (at) { taken.push(at); l.element.style.left = at.x + "px"; l.element.style.top = at.y + "px"; }
    }
  }
}
