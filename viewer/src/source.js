// The source beside the path: only the lines in sight are in the page, so that a million statements scroll.

const rowHeight = 18;

export class Source {
  constructor(scene, onPick) {
    this.scene = scene;
    this.onPick = onPick;
    this.box = document.getElementById("source");
    this.space = document.getElementById("sourceSpace");
    this.rows = document.getElementById("sourceLines");
    this.lines = scene.sources.map(s => s.text.split(/\r\n|\r|\n/));
    this.stretches = scene.sources.map(() => new Map()); // line -> stretches
    for (let k = 0; k < scene.line.length; ++k) {
      const map = this.stretches[scene.file[k]];
      if (!map || !scene.line[k]) continue;
      const known = map.get(scene.line[k]);
      if (known) known.push(k); else map.set(scene.line[k], [k]);
    }
    this.bad = scene.sources.map(() => new Map());
    for (const m of scene.messages) if (m.line && this.bad[m.file]) this.bad[m.file].set(m.line, m);
    this.file = 0;
    this.marked = 0;
    this.box.addEventListener("scroll", () => this.draw());
    this.rows.addEventListener("click", e => {
      const row = e.target.closest(".row");
      if (row) this.onPick(this.file, Number(row.dataset.line), this.stretches[this.file].get(Number(row.dataset.line)) || []);
    });
    this.tabs();
    this.open(0);
  }

  tabs() {
    const tabs = document.getElementById("tabs");
    tabs.hidden = this.scene.sources.length < 2;
    this.scene.sources.forEach((s, i) => {
      const tab = document.createElement("button");
      tab.textContent = s.name.split("/").pop();
      tab.title = s.name;
      tab.addEventListener("click", () => this.open(i));
      tabs.append(tab);
    });
  }

  open(file) {
    this.file = file;
    [...document.getElementById("tabs").children].forEach((t, i) => t.classList.toggle("on", i === file));
    const lines = this.lines[file] || [];
    // A page has a greatest height: beyond it rows share it.
    this.scale = Math.max(1, lines.length * rowHeight / 8e6);
    this.space.style.height = lines.length * rowHeight / this.scale + "px";
    this.draw();
  }

  // Rows that fit, the greatest first row, and how far that is to scroll.
  room() {
    const lines = (this.lines[this.file] || []).length, fit = Math.ceil(this.box.clientHeight / rowHeight) + 2;
    return {fit, last: Math.max(0, lines - fit + 2), way: Math.max(1, lines * rowHeight / this.scale - this.box.clientHeight)};
  }

  firstRow() {
    const {last, way} = this.room();
    return Math.min(last, Math.floor(this.scale > 1 ? this.box.scrollTop / way * last : this.box.scrollTop / rowHeight));
  }

  draw() {
    const lines = this.lines[this.file] || [], {fit} = this.room(), top = this.firstRow();
    this.rows.style.top = (this.scale > 1 ? this.box.scrollTop : top * rowHeight) + "px";
    this.rows.replaceChildren();
    for (let i = top; i < Math.min(lines.length, top + fit); ++i) {
      const row = document.createElement("div"), number = document.createElement("span"), message = this.bad[this.file].get(i + 1);
      row.className = "row" + (this.stretches[this.file].has(i + 1) ? " moves" : "") + (i + 1 === this.marked ? " marked" : "") +
        (message ? message.error ? " bad" : " odd" : "");
      row.dataset.line = i + 1;
      if (message) row.title = message.code + ": " + message.text;
      number.className = "number";
      number.textContent = i + 1;
      row.append(number, visible(lines[i].slice(0, 400)));
      this.rows.append(row);
    }
  }

  mark(file, line, scroll = true) {
    this.marked = line;
    if (file !== this.file) this.open(file);
    const {fit, last, way} = this.room(), top = this.firstRow();
    if (scroll && (line - 1 < top || line - 1 > top + fit - 5)) {
      const first = Math.min(last, Math.max(0, line - 1 - Math.floor(fit / 2)));
      this.box.scrollTop = this.scale > 1 ? first / Math.max(1, last) * way : first * rowHeight;
    }
    this.draw();
  }
}

// Control characters as people can see them.
export const visible = text => text.replace(/[\x00-\x08\x0b-\x1f\x7f-\x9f\u200b-\u200f\u202a-\u202e\u2066-\u2069]/g,
  c => "\\x" + c.codePointAt(0).toString(16).toUpperCase().padStart(2, "0"));
