// Puts the page together: what is chosen, what time it is, and who has to know.
import * as THREE from "three";
import {scene, locationAt, number, coordinate, GUN, START, RAPID, ARC} from "./data.js";
import {Stage, viewNames} from "./stage.js";
import {Source, visible} from "./source.js";
import {Charts} from "./charts.js";
import {filmColor} from "./things.js";

const $ = id => document.getElementById(id);
const stage = new Stage(scene);
const state = {time: scene.total, playing: false, pace: 1, coloring: "kind", measuring: false, measured: [], section: false, chosen: -1};

$("title").textContent = visible(scene.title);
const seconds = t => t < 100 ? t.toFixed(2) + " s" : Math.floor(t / 60) + " min " + (t % 60).toFixed(0) + " s";
$("summary").title = $("summary").textContent = scene.count
  ? `${scene.count.toLocaleString("en")} locations, ${number(scene.way[scene.count - 1], 6)} ${scene.unit}, ${scene.timed ? seconds(scene.total) : "no feed: not timed"}`
  : "no motion";

// A moment of the path: its time, or how far along it is where no time is known.
const along = t => {
  const i = locationAt(scene, t), next = Math.min(i + 1, scene.count - 1), span = scene.time[next] - scene.time[i];
  return scene.count ? scene.way[i] + (span > 0 ? (t - scene.time[i]) / span * (scene.way[next] - scene.way[i]) : 0) : 0;
};
const moment = t => scene.timed ? seconds(t) : `${number(along(t), 5)} ${scene.unit}`;

// ---- messages: errors first; numbers to what can be told apart
const rounded = text => text.replace(/-?\d+\.\d{7,}(?:e[-+]?\d+)?/g, v => coordinate(Number(v)));
const sorted = [...scene.messages].sort((a, b) => Number(b.error) - Number(a.error));
const errors = sorted.filter(m => m.error).length, warnings = sorted.filter(m => !m.error && m.code).length;
const counted = (n, word) => n ? [`${n} ${word}${n > 1 ? "s" : ""}`] : [];
if (sorted.length > 3) {
  $("messageHead").hidden = false;
  $("messageHead").textContent = [...counted(errors, "error"), ...counted(warnings, "warning"), ...counted(sorted.length - errors - warnings, "note")].join(", ");
}
for (const m of sorted) {
  const row = document.createElement("div");
  row.className = "message " + (m.error ? "error" : m.code ? "warning" : "note");
  row.textContent = (m.code ? `${m.code}${m.line ? ", line " + m.line : ""}: ` : "") + rounded(visible(m.text));
  if (m.line) { row.tabIndex = 0; row.addEventListener("click", () => source.mark(m.file, m.line)); }
  $("messageList").append(row);
}
const cue = () => { const l = $("messageList"); $("messages").classList.toggle("more", l.scrollHeight - l.scrollTop - l.clientHeight > 6); };
$("messageList").addEventListener("scroll", cue);
new ResizeObserver(cue).observe($("messageList"));

// ---- choice of a statement, both ways
function choose(stretch, scroll = true) {
  state.chosen = stretch;
  const end = stretch + 1 < scene.first.length ? scene.first[stretch + 1] : scene.count;
  stage.path.material.uniforms.chosen.value.set(stretch < 0 ? -1 : scene.first[stretch] - 0.5, stretch < 0 ? -1 : end - 0.5);
  if (stretch >= 0 && scene.line[stretch]) source.mark(scene.file[stretch], scene.line[stretch], scroll);
  stage.request();
}

const show = place => `(${place.map(coordinate).join(", ")})`;
// What is known of the move to a location; `at`: the place of it that was clicked.
function tell(index, at = null) {
  const k = scene.stretchOf[index], end = [0, 1, 2].map(a => scene.places[3 * index + a]), lines = [];
  const ends = at && Math.hypot(...at.map((v, a) => v - end[a])) <= 1e-9 * scene.size;
  lines.push(`line ${scene.line[k]}   ${["start", "rapid", "feed", "arc"][scene.kinds[index] & 15]}${scene.kinds[index] & GUN ? ", gun on" : ""}`);
  if (at && !ends) lines.push(`at ${show(at)} ${scene.unit}`, `move ends at ${show(end)}`);
  else lines.push(`${show(end)} ${scene.unit}`);
  lines.push((scene.timed ? `${seconds(scene.time[index])}   ${number(scene.speed[index], 4)} ${scene.unit}/s   ` : `${moment(scene.time[index])} along the path   `) + `curvature ${number(scene.curvature[index], 4)}`);
  if (!Number.isNaN(scene.inner[k])) {
    const bound = v => number(Math.abs(v) < 1e-9 * scene.size ? 0 : v, 3);
    lines.push(`proven: ${bound(scene.inner[k])} to ${bound(scene.outer[k])} off its surfaces, ${bound(-scene.allowedInner[k])} to ${bound(scene.allowedOuter[k])} allowed`);
  }
  $("readout").textContent = lines.join("\n");
}

const source = new Source(scene, (file, line, stretches) => {
  source.mark(file, line, false);
  if (!stretches.length) {
    choose(-1);
    source.mark(file, line, false);
    $("readout").textContent = `line ${line}: no motion`;
    return;
  }
  const next = stretches[(stretches.indexOf(state.chosen) + 1) % stretches.length]; // again: the next execution
  choose(next, false);
  const last = (next + 1 < scene.first.length ? scene.first[next + 1] : scene.count) - 1;
  tell(last);
  setTime(scene.time[last]);
});
const charts = new Charts(scene, moment, time => { pause(); setTime(time); const i = locationAt(scene, time); choose(scene.stretchOf[i]); tell(i); });

function tellPlace(found) {
  const lines = [visible(found.name), `${show(found.place)} ${scene.unit}`], f = found.film;
  if (f) lines.push(f.relative ? `film ${number(100 * f.value, 3)} % of the mean` : `film ${number(1000 * f.value, 3)} \u00b5m, wanted ${number(1000 * f.wanted, 3)}`);
  $("readout").textContent = lines.join("\n");
}

let pressed = null;
stage.canvas.addEventListener("pointerdown", e => { pressed = [e.offsetX, e.offsetY]; });
stage.canvas.addEventListener("pointerup", e => {
  if (!pressed || Math.hypot(e.offsetX - pressed[0], e.offsetY - pressed[1]) > 4) return;
  const found = stage.under(e.offsetX, e.offsetY);
  if (state.measuring) return measure(found);
  if (!found) { choose(-1); $("readout").textContent = ""; return; }
  if (found.index < 0) { tellPlace(found); return; }
  choose(scene.stretchOf[found.index]);
  tell(found.index, found.place);
});

// ---- measuring
function measure(found) {
  if (!found) return;
  if (state.measured.length === 2) state.measured = [];
  state.measured.push(found.place);
  stage.measure(state.measured);
  const [a, b] = state.measured;
  if (!b) { $("readout").textContent = `from ${show(a)}\nclick the second place`; return; }
  const d = b.map((v, k) => v - a[k]);
  $("readout").textContent = `from ${show(a)}\nto   ${show(b)}\ndistance ${number(Math.hypot(...d), 8)} ${scene.unit}\ndx ${number(d[0], 8)}   dy ${number(d[1], 8)}   dz ${number(d[2], 8)}`;
}
function toggleMeasure() {
  state.measuring = !state.measuring;
  state.measured = [];
  stage.measure([]);
  $("measure").classList.toggle("on", state.measuring);
  $("readout").textContent = state.measuring ? "click the first place, on the path or on a surface" : "";
}

// ---- time
function setTime(time) {
  state.time = Math.min(scene.total, Math.max(0, time));
  const i = scene.count ? locationAt(scene, state.time) : -1, next = Math.min(i + 1, scene.count - 1);
  stage.path.material.uniforms.head.value = state.time >= scene.total ? 1e9 : i + 0.5;
  if (i >= 0) {
    const span = scene.time[next] - scene.time[i], t = span > 0 ? (state.time - scene.time[i]) / span : 0, axis = new THREE.Vector3(0, 0, 1);
    const place = new THREE.Vector3(...[0, 1, 2].map(a => scene.places[3 * i + a] * (1 - t) + scene.places[3 * next + a] * t - stage.center[a]));
    if (scene.axes.length) axis.set(...[0, 1, 2].map(a => scene.axes[3 * i + a] * (1 - t) + scene.axes[3 * next + a] * t)).normalize();
    stage.tool.put(place, axis, i, (scene.kinds[next] & GUN) !== 0);
  }
  $("time").value = scene.total > 0 ? 10000 * state.time / scene.total : 10000;
  $("clock").textContent = `${moment(state.time)} of ${moment(scene.total)}`;
  charts.draw(state.time);
  stage.request();
}
let before = 0;
function frame(now) {
  if (!state.playing) return;
  setTime(state.time + Math.min(0.1, (now - before) / 1000) * state.pace);
  before = now;
  if (scene.count) { const k = scene.stretchOf[locationAt(scene, state.time)]; if (k !== state.chosen) choose(k); }
  if (state.time >= scene.total) pause(); else requestAnimationFrame(frame);
}
function play() {
  if (!scene.count) return;
  if (state.time >= scene.total) setTime(0);
  state.playing = stage.playing = true;
  $("play").textContent = "\u23f8";
  before = performance.now();
  requestAnimationFrame(frame);
}
function pause() {
  state.playing = stage.playing = false;
  $("play").textContent = "\u25b6";
  stage.request();
}
const toggle = () => state.playing ? pause() : play();
$("play").addEventListener("click", toggle);
$("time").addEventListener("input", e => { pause(); setTime(scene.total * e.target.value / 10000); });
for (const p of [0.1, 0.5, 1, 2, 5, 10, 50, 200, 1000]) $("pace").add(new Option(p + "\u00d7", p, p === 1, p === 1));
$("pace").addEventListener("change", e => { state.pace = Number(e.target.value); });

// ---- coloring and legend
const present = new Set(); // kinds, with 4 for the gun
for (let i = 0; i < scene.count; ++i) present.add(scene.kinds[i] & GUN && (scene.kinds[i] & 15) > RAPID ? 4 : scene.kinds[i] & 15);
const colorings = {
  kind: {text: "kind"},
  speed: {text: "speed", value: i => scene.speed[i], top: charts.top[0], unit: scene.unit + "/s"},
  feed: {text: "programmed feed", value: i => scene.feed[scene.stretchOf[i]] || NaN, top: scene.feed.reduce((a, b) => Math.max(a, b), 0), unit: scene.unit + "/min"},
  curvature: {text: "curvature", value: i => scene.curvature[i], top: charts.top[1], unit: "1/" + scene.unit.replace(/units$/, "unit")},
  deviation: {text: "deviation bound", value: i => Math.max(Math.abs(scene.inner[scene.stretchOf[i]]), Math.abs(scene.outer[scene.stretchOf[i]])), top: charts.top[2], unit: scene.unit},
  time: scene.timed ? {text: "time", value: i => scene.time[i], top: scene.total, unit: "s"}
    : {text: "way", value: i => scene.way[i], top: scene.count ? scene.way[scene.count - 1] : 0, unit: scene.unit},
};
for (const [name, c] of Object.entries(colorings)) $("coloring").add(new Option(c.text, name));
function color(name) {
  state.coloring = name;
  $("coloring").value = name;
  const c = colorings[name];
  let amounts = null;
  if (c.value) {
    amounts = new Float32Array(scene.count);
    for (let i = 0; i < scene.count; ++i) amounts[i] = (scene.kinds[i] & 15) === RAPID && name !== "speed" && name !== "time" ? NaN : c.value(i) / (c.top || 1);
  }
  stage.path.paint(amounts);
  legend();
  stage.request();
}
$("coloring").addEventListener("change", e => color(e.target.value));

function legend() {
  const box = $("legend"), c = colorings[state.coloring], row = (ink, text) => {
    const d = document.createElement("div"), i = document.createElement("i");
    i.style.background = ink;
    d.append(i, text);
    box.append(d);
  };
  const ramp = (stops, low, high) => {
    const d = document.createElement("div"), bar = document.createElement("span");
    bar.className = "ramp";
    bar.style.background = `linear-gradient(90deg, ${stops})`;
    d.append(low, bar, high);
    box.append(d);
  };
  box.replaceChildren();
  if (c.value) {
    ramp("#2166cc, #29a659 34%, #edb81a 67%, #d9261f", "0", `${number(c.top, 3)} ${c.unit}`);
  } else {
    const guns = present.has(4);
    if (present.has(1)) row(stage.colors[1], "rapid");
    if (present.has(2)) row(stage.colors[2], guns ? "feed, gun off" : "feed");
    if (present.has(ARC)) row(stage.colors[3], "along a circle or spline");
    if (guns) row(stage.colors[4], "gun on");
  }
  if (scene.films.length) {
    const w = scene.films[0].wanted, ink = t => "#" + filmColor(t, 1).getHexString();
    const ends = scene.films[0].relative ? ["film 50 %", "150 % of its mean"] : [`film ${number(500 * w, 3)}`, `${number(1500 * w, 3)} \u00b5m, wanted ${number(1000 * w, 3)}`];
    ramp([0.5, 0.75, 1, 1.25, 1.5].map(ink).join(", "), ...ends);
  }
  const bar = document.createElement("div"), line = document.createElement("span"), text = document.createElement("span");
  line.className = "bar";
  line.id = "barLine";
  text.id = "barText";
  bar.append(line, text);
  const thinned = document.createElement("div");
  thinned.id = "thinned";
  box.append(bar, thinned);
  scaleBar();
}
function scaleBar() {
  const line = $("barLine");
  if (!line) return;
  const most = 120 * stage.unitsPerPixel(), power = 10 ** Math.floor(Math.log10(most)), size = [5, 2, 1].map(f => f * power).find(v => v <= most);
  line.style.width = size / stage.unitsPerPixel() + "px";
  $("thinned").textContent = stage.path.thinned;
  $("barText").textContent = `${number(size, 3)} ${size === 1 && scene.unit === "units" ? "unit" : scene.unit}`;
}
stage.afterRender = scaleBar;

// ---- layers, views, section, theme, keys
const has = {path: scene.count > 1, surfaces: scene.meshes.some(m => !m.auxiliary), unnamed: scene.meshes.some(m => m.auxiliary), film: scene.films.length > 0, geometry: scene.entities.length > 0, tool: scene.count > 0};
for (const name of Object.keys(stage.layers)) {
  if (!has[name]) continue;
  const label = document.createElement("label"), box = document.createElement("input");
  box.type = "checkbox";
  box.checked = stage.layers[name].visible;
  box.addEventListener("change", () => { stage.layers[name].visible = box.checked; stage.request(); });
  label.append(box, " " + (name === "unnamed" ? "nested surfaces" : name));
  $("layers").append(label);
}
$("layers").hidden = !$("layers").children.length;
for (const name of Object.keys(viewNames)) {
  const b = document.createElement("button");
  b.textContent = name;
  b.addEventListener("click", () => stage.look(name));
  $("views").append(b, " ");
}
function section() {
  $("cut").hidden = !state.section;
  $("section").classList.toggle("on", state.section);
  const place = stage.section($("cutAxis").value, $("cutPlace").value / 1000, $("cutFlip").checked, state.section);
  $("cutValue").textContent = `${number(place, 4)} ${scene.unit}`;
}
$("section").addEventListener("click", () => { state.section = !state.section; section(); });
// The keys move the plane by a fortieth of its way.
function shift(n) {
  if (!state.section) state.section = true;
  $("cutPlace").value = Number($("cutPlace").value) + 25 * n;
  section();
}
for (const id of ["cutAxis", "cutPlace", "cutFlip"]) $(id).addEventListener("input", section);
$("measure").addEventListener("click", toggleMeasure);
function theme() {
  stage.dark(!stage.isDark);
  $("theme").textContent = stage.isDark ? "light" : "dark";
  legend();
  charts.draw();
}
$("theme").addEventListener("click", theme);

const step = n => {
  if (!scene.first.length) return;
  const k = Math.min(scene.first.length - 1, Math.max(0, (state.chosen < 0 ? (n > 0 ? -1 : scene.first.length) : state.chosen) + n));
  const last = (k + 1 < scene.first.length ? scene.first[k + 1] : scene.count) - 1;
  pause();
  choose(k);
  tell(last);
  setTime(scene.time[last]);
};
const cycle = () => { const names = Object.keys(colorings); color(names[(names.indexOf(state.coloring) + 1) % names.length]); };
const keys = {
  " ": ["play and pause", toggle], ArrowRight: ["next statement", () => step(1)], ArrowLeft: ["statement before", () => step(-1)],
  Home: ["to the start", () => setTime(0)], End: ["to the end", () => setTime(scene.total)],
  1: ["plan", () => stage.look("plan")], 2: ["front", () => stage.look("front")], 3: ["side", () => stage.look("side")], 4: ["iso", () => stage.look("iso")],
  c: ["next coloring", cycle], m: ["measure", toggleMeasure], x: ["section", () => { state.section = !state.section; section(); }],
  "[": ["section plane back", () => shift(-1)], "]": ["section plane on", () => shift(1)],
  d: ["dark or light", theme], Escape: ["nothing chosen", () => { if (state.measuring) toggleMeasure(); choose(-1); $("readout").textContent = ""; }],
  "?": ["these keys", () => $("keys").open ? $("keys").close() : $("keys").showModal()],
};
const table = document.createElement("table");
for (const [key, [text]] of Object.entries(keys)) {
  const r = table.insertRow();
  r.insertCell().textContent = key === " " ? "space" : key;
  r.insertCell().textContent = text;
}
$("keys").append(table);
$("keys").addEventListener("click", () => $("keys").close());
$("help").addEventListener("click", () => $("keys").showModal());
// A control that was used gives the keyboard back.
addEventListener("change", e => { if (/^(SELECT|INPUT)$/.test(e.target.tagName)) e.target.blur(); });
addEventListener("keydown", e => {
  if (e.ctrlKey || e.metaKey || e.altKey || /^(SELECT|INPUT)$/.test(e.target.tagName)) return;
  if ($("keys").open && e.key !== "?") return; // Escape closes it
  const key = keys[e.key];
  if (key) { e.preventDefault(); key[1](); }
});
addEventListener("resize", () => charts.draw());
if (window.matchMedia && matchMedia("(prefers-color-scheme: dark)").matches) theme();

color("kind");
setTime(scene.total);
// For tests: what is shown, in numbers.
window.arelem = {scene, state, stage, choose, setTime, color, levels: () => stage.path.totals(), ready: true};
