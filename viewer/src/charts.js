// Speed with the programmed feed, curvature and proven deviation over the time of the path, a column of pixels at a time.
import {number, locationAt, RAPID, START} from "./data.js";

// Thousands of narrow bars: the processor paints them at once, what stands in for a graphics card takes seconds.
const inMemory = {willReadFrequently: true};
// A circle of this many sizes of the path is a straight line with rounded coordinates.
const straight = 1e-6;
const names = ["speed", "curvature", "deviation"];

export class Charts {
  constructor(scene, moment, onPick) {
    this.moment = moment;
    this.scene = scene;
    this.canvas = document.getElementById("charts");
    this.from = 0;
    this.to = Math.max(scene.total, 1e-9);
    this.now = this.to;
    this.canvas.addEventListener("click", e => onPick(this.timeAt(e.offsetX)));
    this.canvas.addEventListener("pointermove", e => { this.pointed = this.timeAt(e.offsetX); this.tell(); });
    this.canvas.addEventListener("pointerleave", () => { this.pointed = null; this.tell(); });
    this.canvas.addEventListener("wheel", e => {
      e.preventDefault();
      const t = this.timeAt(e.offsetX), f = e.deltaY > 0 ? 1.25 : 0.8, all = Math.max(scene.total, 1e-9);
      const span = Math.min(all, Math.max((this.to - this.from) * f, all * 1e-6));
      this.from = Math.min(Math.max(0, t - (t - this.from) * span / (this.to - this.from)), all - span);
      this.to = this.from + span;
      this.draw();
    }, {passive: false});
    this.limits();
  }

  limits() {
    const s = this.scene;
    this.top = [0, 0, 0];
    const curved = [];
    let rapid = 0;
    for (let i = 1; i < s.count; ++i) {
      const kind = s.kinds[i] & 15;
      if (kind === RAPID || !s.timed) rapid = Math.max(rapid, s.timed ? s.speed[i] : 0);
      else if (kind !== START) this.top[0] = Math.max(this.top[0], s.speed[i], this.feedAt(i));
      if (s.curvature[i] > 0 && curved.length < 200000) curved.push(s.curvature[i]);
    }
    this.top[0] = this.top[0] > 0 ? 1.15 * this.top[0] : rapid; // rapid moves would dwarf the rest: they reach over the edge
    const bends = Float32Array.from(curved).sort();
    const bend = bends.length ? bends[Math.floor(0.98 * (bends.length - 1))] : 0; // a single corner would dwarf the rest
    this.top[1] = bend * s.size > straight ? 1.15 * bend : 0;
    for (let k = 0; k < s.first.length; ++k) for (const a of [s.inner, s.outer, s.allowedInner, s.allowedOuter]) {
      if (!Number.isNaN(a[k])) this.top[2] = Math.max(this.top[2], Math.abs(a[k]));
    }
  }

  // The programmed feed of a move, a second; NaN for rapid moves and where none is known.
  feedAt(i) {
    const feed = this.scene.feed[this.scene.stretchOf[i]];
    return this.scene.timed && feed > 0 && (this.scene.kinds[i] & 15) > RAPID ? feed / 60 : NaN;
  }

  // What the pointer is at, beside the clock.
  tell() {
    const s = this.scene, box = document.getElementById("pointed");
    if (this.pointed === null || s.count < 2) { box.textContent = ""; return; }
    const i = Math.min(s.count - 1, locationAt(s, this.pointed) + 1), k = s.stretchOf[i], feed = this.feedAt(i);
    box.textContent = `${this.moment(this.pointed)}: line ${s.line[k]}` + (s.timed ? `, ${number(s.speed[i], 4)} ${s.unit}/s` : "") + (feed > 0 ? ` of ${number(feed, 4)}` : "") +
      `, curvature ${number(s.curvature[i], 3)}` + (Number.isNaN(s.inner[k]) ? "" : `, off by ${number(s.inner[k], 2)} to ${number(s.outer[k], 2)}`);
  }

  timeAt(x) { return this.from + (this.to - this.from) * Math.min(1, Math.max(0, (x - 66) / (this.canvas.clientWidth - 76))); }

  draw(now = this.now) {
    this.now = now;
    const c = this.canvas, ratio = window.devicePixelRatio || 1, w = c.clientWidth, h = c.clientHeight;
    const key = [w, h, ratio, this.from, this.to, document.documentElement.className].join();
    if (key !== this.painted) { // curves of a long path take long: only the mark of the time moves
      this.painted = key;
      this.curves = document.createElement("canvas");
      for (const canvas of [c, this.curves]) { canvas.width = Math.max(1, Math.round(w * ratio)); canvas.height = Math.max(1, Math.round(h * ratio)); }
      this.paint(this.curves.getContext("2d", inMemory), ratio, w, h);
    }
    const g = c.getContext("2d", inMemory), left = 66, width = w - left - 10;
    g.setTransform(1, 0, 0, 1, 0, 0);
    g.clearRect(0, 0, c.width, c.height);
    g.drawImage(this.curves, 0, 0);
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    const x = left + width * (now - this.from) / (this.to - this.from);
    if (x >= left && x <= left + width) {
      g.strokeStyle = getComputedStyle(document.documentElement).getPropertyValue("--hot").trim();
      g.beginPath();
      g.moveTo(x, 2);
      g.lineTo(x, h - 2);
      g.stroke();
    }
  }

  paint(g, ratio, w, h) {
    const style = getComputedStyle(document.documentElement), ink = n => style.getPropertyValue(n).trim();
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.font = "11px system-ui, 'DejaVu Sans', sans-serif";
    const left = 66, width = w - left - 10, each = h / 3;
    const inks = document.documentElement.classList.contains("dark") ? ["#6cb2ff", "#3ddc97", "#ff6bd6"] : ["#1f5fbf", "#0a8f6c", "#b5179e"];
    names.forEach((name, row) => {
      const y0 = row * each + 4, tall = each - 9;
      g.strokeStyle = ink("--line");
      g.strokeRect(left - 0.5, y0 - 0.5, width + 1, tall + 1);
      g.fillStyle = ink("--soft");
      const most = this.top[row] > 0 ? number(this.top[row], 3) : "", unit = most ? [this.scene.unit + "/s", "1/" + this.scene.unit.replace(/units$/, "unit"), this.scene.unit][row] : "";
      const words = tall < 30 ? [name, `${most} ${unit}`] : [name, most, unit];
      words.forEach((text, k) => g.fillText(text, 8, y0 + 11 + 12.5 * k));
      if (this.scene.count < 2 || !(this.top[row] > 0)) {
        g.fillText(row === 2 ? "no motion along surfaces was proven" : row === 1 ? "straight" : this.scene.count > 1 && !this.scene.timed ? "no feed: not timed" : "none", left + 8, y0 + tall / 2 + 4);
        return;
      }
      this.curve(g, row, left, width, y0, tall, inks[row]);
    });
  }

  curve(g, row, left, width, y0, tall, color) {
    const s = this.scene, step = (this.to - this.from) / width;
    let i = Math.max(1, locationAt(s, this.from));
    const hot = getComputedStyle(document.documentElement).getPropertyValue("--hot").trim();
    g.fillStyle = color;
    for (let x = 0; x < width; ++x) {
      const until = this.from + (x + 1) * step;
      let low = Infinity, high = -Infinity, allowedLow = NaN, allowedHigh = NaN, feed = NaN, n = 0;
      for (; i < s.count; ++i) {
        const k = s.stretchOf[i];
        for (const v of row === 0 ? [s.speed[i]] : row === 1 ? [s.curvature[i]] : [s.inner[k], s.outer[k]]) {
          if (!Number.isNaN(v)) { low = Math.min(low, v); high = Math.max(high, v); }
        }
        allowedLow = -s.allowedInner[k];
        allowedHigh = s.allowedOuter[k];
        feed = this.feedAt(i);
        if (s.time[i] > until || ++n > 20000) break;
      }
      if (row === 2) {
        const y = v => y0 + tall / 2 * (1 - 0.94 * v / this.top[2]);
        g.globalAlpha = 0.14;
        if (allowedLow <= allowedHigh) g.fillRect(left + x, y(allowedHigh), 1, Math.max(1, y(allowedLow) - y(allowedHigh)));
        g.globalAlpha = 0.6;
        for (const a of [allowedLow, allowedHigh]) if (!Number.isNaN(a)) g.fillRect(left + x, y(a) - 0.5, 1, 1);
        g.globalAlpha = 1;
        if (low <= high) g.fillRect(left + x, Math.min(y(high), y(low)), 1, Math.max(1.5, Math.abs(y(low) - y(high))));
      } else if (low <= high) {
        const y = v => y0 + tall * (1 - Math.min(1, v / this.top[row]));
        g.globalAlpha = 0.28;
        g.fillRect(left + x, y(high), 1, y0 + tall - y(high));
        g.globalAlpha = 1;
        g.fillRect(left + x, y(high), 1, Math.max(1.5, y(low) - y(high)));
        if (row === 0 && feed > 0 && x % 6 < 3) { // dashed: as programmed
          g.fillStyle = hot;
          g.fillRect(left + x, y(feed) - 0.5, 1, 1.5);
          g.fillStyle = color;
        }
      }
    }
  }
}
