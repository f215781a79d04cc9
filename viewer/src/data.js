// The scene as the page holds it: numbers from base64, and what follows from them.

const arrays = {f64: Float64Array, f32: Float32Array, u32: Uint32Array, u8: Uint8Array};

function unpacked(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const raw = atob(text), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

// With a count, the one value stands for that many.
async function read(id, kind) {
  const element = document.getElementById(id), count = element ? Number(element.dataset.count || 0) : 0;
  if (!element) return new arrays[kind](0);
  const packed = new Blob([unpacked(element.textContent)]);
  element.remove(); // the text is large and not needed again
  const values = new arrays[kind](await new Response(packed.stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer());
  return count > 0 ? new arrays[kind](count).fill(values[0]) : values;
}

export const GUN = 16;
export const START = 0, RAPID = 1, FEED = 2, ARC = 3;

// Kinds of numbers, by their names in the page and here.
const named = {
  places: "f64", axes: "f32", kinds: "u8", seconds: "f32", first: "u32", line: "u32", file: "u32", feed: "f32",
  inner: "f32", outer: "f32", allowedInner: "f32", allowedOuter: "f32", levels: "u8", boxes: "f32", tolerances: "f64",
};

export let scene = null; // after load()

export async function load() {
  const s = JSON.parse(document.getElementById("scene").textContent), waiting = [];
  const want = (object, name, id, kind) => waiting.push(read(id, kind).then(values => { object[name] = values; }));
  for (const [name, kind] of Object.entries(named)) want(s, name, name, kind);
  s.sources.forEach((source, i) => want(source, "bytes", "source" + i, "u8"));
  s.meshes.forEach((m, i) => {
    want(m, "places", "meshPlaces" + i, "f32");
    want(m, "normals", "meshNormals" + i, "f32");
    want(m, "triangles", "meshTriangles" + i, "u32");
  });
  s.films.forEach((f, i) => {
    want(f, "corners", "filmCorners" + i, "f32");
    want(f, "film", "film" + i, "f32");
  });
  await Promise.all(waiting);
  derive(s);
  scene = s;
}

function derive(s) {
  const n = s.kinds.length, p = s.places;
  s.count = n;
  s.time = new Float64Array(n);
  s.way = new Float64Array(n);
  s.stretchOf = new Uint32Array(n);
  s.curvature = new Float32Array(n);
  s.speed = new Float32Array(n);
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let a = 0; a < 3; ++a) for (let i = a; i < 3 * n; i += 3) {
    if (p[i] < low[a]) low[a] = p[i];
    if (p[i] > high[a]) high[a] = p[i];
  }
  for (let i = 0, k = 0; i < n; ++i) {
    while (k + 1 < s.first.length && s.first[k + 1] <= i) ++k;
    s.stretchOf[i] = k;
    if (i === 0) continue;
    const moved = (s.kinds[i] & 15) !== START;
    const length = moved ? size(p[3 * i] - p[3 * i - 3], p[3 * i + 1] - p[3 * i - 2], p[3 * i + 2] - p[3 * i - 1]) : 0;
    s.way[i] = s.way[i - 1] + length;
    s.time[i] = s.time[i - 1] + s.seconds[i];
    s.speed[i] = s.seconds[i] > 0 ? length / s.seconds[i] : 0;
  }
  s.extent = n ? size(high[0] - low[0], high[1] - low[1], high[2] - low[2]) : 0;
  curvatures(s);
  for (const f of s.films) for (let i = 0; i < f.corners.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], f.corners[i]);
    high[i % 3] = Math.max(high[i % 3], f.corners[i]);
  }
  if (n === 0) extentOfGeometry(s, low, high);
  if (!(low[0] <= high[0])) {
    low.fill(-50);
    high.fill(50);
  }
  s.low = low;
  s.high = high;
  s.total = n ? s.time[n - 1] : 0;
  s.size = Math.max(Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]), 1e-9);
}

// Where there is no path: what has a place.
function extentOfGeometry(s, low, high) {
  const take = (x, y, z, r = 0) => [x, y, z].forEach((v, a) => { low[a] = Math.min(low[a], v - r); high[a] = Math.max(high[a], v + r); });
  for (const e of s.entities) {
    const c = e.canon;
    if (e.type === "POINT") take(c[0], c[1], c[2]);
    else if (e.type === "CIRCLE") { take(c[0] - c[6], c[1] - c[6], c[2]); take(c[0] + c[6], c[1] + c[6], c[2]); }
    else if (e.type === "SPHERE") take(c[0], c[1], c[2], c[3]);
    else if (e.type === "PATERN") for (let k = 0; k + 2 < c.length; k += 3) take(c[k], c[k + 1], c[k + 2]);
    for (const curve of e.curves || []) for (let k = 0; k < curve.length; k += 3) take(curve[k], curve[k + 1], curve[k + 2]);
  }
}

// Math.hypot guards against overflow, and takes ten times as long.
const size = (x, y, z) => Math.sqrt(x * x + y * y + z * z);

// Of each move: the larger of those at its ends. Corners have none, and a straight move between two of them has 0.
const sharpest = Math.cos(50 * Math.PI / 180);
function curvatures(s) {
  const n = s.count, moves = k => (s.kinds[k] & 15) > RAPID, at = new Float32Array(n);
  for (let i = 1; i + 1 < n; ++i) if (moves(i) && moves(i + 1)) at[i] = curvatureAt(s.places, i);
  for (let k = 0; k < s.first.length; ++k) {
    const first = s.first[k], last = (k + 1 < s.first.length ? s.first[k + 1] : n) - 2;
    // The first and last cut vectors of a motion are shorter than the others, and end elsewhere in the tolerance.
    if (last - first > 3) { at[first] = at[first + 1]; at[last] = at[last - 1]; }
  }
  // Where a long move meets a short one the circle through both tells nothing of the long one, which is straight: pieces of a
  // curve do not differ that much.
  const longest = 3, length = i => s.way[i] - s.way[i - 1];
  for (let i = 1; i < n; ++i) {
    const before = i > 1 && length(i) <= longest * length(i - 1) ? at[i - 1] : 0;
    const behind = i + 1 < n && length(i) <= longest * length(i + 1) ? at[i] : 0;
    s.curvature[i] = Math.max(before, behind);
  }
  for (let k = 0; k < s.first.length; ++k) { // motions straight in all their cut vectors
    const first = s.first[k], last = (k + 1 < s.first.length ? s.first[k + 1] : n) - 1;
    let bend = 0;
    for (let i = Math.max(1, first); i < last; ++i) bend = Math.max(bend, at[i]);
    if (last > first && bend * s.extent < 1e-6) s.curvature.fill(0, Math.max(1, first), last + 1);
  }
}

// Of the circle through three places that follow one another: 4 areas over the product of the sides; 0 at a corner.
function curvatureAt(p, i) {
  const ax = p[3 * i] - p[3 * i - 3], ay = p[3 * i + 1] - p[3 * i - 2], az = p[3 * i + 2] - p[3 * i - 1];
  const bx = p[3 * i + 3] - p[3 * i], by = p[3 * i + 4] - p[3 * i + 1], bz = p[3 * i + 5] - p[3 * i + 2];
  const a = size(ax, ay, az), b = size(bx, by, bz), product = a * b * size(ax + bx, ay + by, az + bz);
  if (!(product > 0) || ax * bx + ay * by + az * bz < sharpest * a * b) return 0;
  return 2 * size(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx) / product;
}

// The last location at or before a moment.
export function locationAt(s, time) {
  let a = 0, b = s.count - 1;
  while (a < b) {
    const m = (a + b + 1) >> 1;
    if (s.time[m] <= time) a = m; else b = m - 1;
  }
  return a;
}

// A place of the path, as exact as its size makes sense of, and as a double is.
export function coordinate(v) {
  if (!Number.isFinite(v)) return "-";
  const whole = Math.max(1, Math.floor(Math.log10(Math.max(1, Math.abs(v)))) + 1);
  const digits = Math.min(6 - Math.floor(Math.log10(scene.size)), 15 - whole);
  return String(+v.toFixed(Math.max(0, Math.min(9, digits))));
}

export const number = (v, digits = 6) => Number.isFinite(v) ? String(+v.toPrecision(digits)) : "-";
