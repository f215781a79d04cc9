// The scene as the page holds it: numbers from base64, and what follows from them.

const arrays = {f64: Float64Array, f32: Float32Array, u32: Uint32Array, u8: Uint8Array};

function bytesOf(id) {
  const element = document.getElementById(id);
  const text = element ? element.textContent : "", count = element ? Number(element.dataset.count || 0) : 0;
  if (element) element.remove(); // the text is large and not needed again
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return [bytes.buffer, count];
}

// With a count, the one value stands for that many.
function read(id, kind) {
  const [bytes, count] = bytesOf(id), values = new arrays[kind](bytes);
  return count > 0 ? new arrays[kind](count).fill(values[0]) : values;
}

export const GUN = 16;
export const START = 0, RAPID = 1, FEED = 2, ARC = 3;

export function load() {
  const scene = JSON.parse(document.getElementById("scene").textContent);
  const s = Object.assign(scene, {
    places: read("places", "f64"), axes: read("axes", "f32"), kinds: read("kinds", "u8"), seconds: read("seconds", "f32"),
    first: read("first", "u32"), line: read("line", "u32"), file: read("file", "u32"), feed: read("feed", "f32"),
    inner: read("inner", "f32"), outer: read("outer", "f32"),
    allowedInner: read("allowedInner", "f32"), allowedOuter: read("allowedOuter", "f32"),
  });
  s.meshes.forEach((m, i) => {
    m.places = read("meshPlaces" + i, "f32");
    m.normals = read("meshNormals" + i, "f32");
    m.triangles = read("meshTriangles" + i, "u32");
  });
  s.films.forEach((f, i) => {
    f.corners = read("filmCorners" + i, "f32");
    f.film = read("film" + i, "f32");
  });
  derive(s);
  return s;
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
  for (let i = 0, k = 0; i < n; ++i) {
    while (k + 1 < s.first.length && s.first[k + 1] <= i) ++k;
    s.stretchOf[i] = k;
    for (let a = 0; a < 3; ++a) {
      low[a] = Math.min(low[a], p[3 * i + a]);
      high[a] = Math.max(high[a], p[3 * i + a]);
    }
    if (i === 0) continue;
    const moved = (s.kinds[i] & 15) !== START;
    const length = moved ? Math.hypot(p[3 * i] - p[3 * i - 3], p[3 * i + 1] - p[3 * i - 2], p[3 * i + 2] - p[3 * i - 1]) : 0;
    s.way[i] = s.way[i - 1] + length;
    s.time[i] = s.time[i - 1] + s.seconds[i];
    s.speed[i] = s.seconds[i] > 0 ? length / s.seconds[i] : 0;
  }
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
  for (let i = 1; i < n; ++i) s.curvature[i] = Math.max(at[i - 1], at[i]);
}

// Of the circle through three places that follow one another: 4 areas over the product of the sides; 0 at a corner.
function curvatureAt(p, i) {
  const ax = p[3 * i] - p[3 * i - 3], ay = p[3 * i + 1] - p[3 * i - 2], az = p[3 * i + 2] - p[3 * i - 1];
  const bx = p[3 * i + 3] - p[3 * i], by = p[3 * i + 4] - p[3 * i + 1], bz = p[3 * i + 5] - p[3 * i + 2];
  const product = Math.hypot(ax, ay, az) * Math.hypot(bx, by, bz) * Math.hypot(ax + bx, ay + by, az + bz);
  if (!(product > 0) || ax * bx + ay * by + az * bz < sharpest * Math.hypot(ax, ay, az) * Math.hypot(bx, by, bz)) return 0;
  return 2 * Math.hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx) / product;
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

export const number = (v, digits = 6) => Number.isFinite(v) ? String(+v.toPrecision(digits)) : "-";
