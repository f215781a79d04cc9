// The source beside the path: only the lines in sight are in the page, so that a million statements scroll.

const rowHeight = 18;

// Where lines begin, and where the text ends. A carriage return alone ends a line too.
function lineStarts(bytes) {
  const returns = bytes.includes(13);
  const next = from => { // behind the next end of a line
    if (!returns) return bytes.indexOf(10, from) + 1;
    for (let i = from; i < bytes.length; ++i) if (bytes[i] === 10 || (bytes[i] === 13 && bytes[i + 1] !== 10)) return i + 1;
    return 0;
  };
  let starts = new Uint32Array(1024), lines = 1;
  for (let at = next(0); at > 0; at = next(at)) {
    if (lines + 1 >= starts.length) {
      const more = new Uint32Array(2 * starts.length);
      more.set(starts);
      starts = more;
    }
    starts[lines++] = at;
  }
  starts[lines] = bytes.length;
  return starts.subarray(0, lines + 1);
}

// Executions of statements by the lines of a file, in two arrays: a million lines stay small.
class Stretches {
  constructor(scene, file, lines) {
    const mine = k => scene.file[k] === file && scene.line[k] > 0 && scene.line[k] < lines;
    this.begin = new Uint32Array(lines + 1);
    for (let k = 0; k < scene.line.length; ++k) if (mine(k)) ++this.begin[scene.line[k] + 1];
    for (let i = 1; i <= lines; ++i) this.begin[i] += this.begin[i - 1];
    const next = this.begin.slice();
    this.all = new Uint32Array(this.begin[lines]);
    for (let k = 0; k < scene.line.length; ++k) if (mine(k)) this.all[next[scene.line[k]]++] = k;
  }

  has(line) { return this.begin[line] < this.begin[line + 1]; }
  of(line) { return [...this.all.subarray(this.begin[line], this.begin[line + 1])]; }
}

export class Source {
  constructor(scene, onPick) {
    this.scene = scene;
    this.onPick = onPick;
    this.box = document.getElementById("source");
    this.space = document.getElementById("sourceSpace");
    this.rows = document.getElementById("sourceLines");
    this.starts = scene.sources.map(s => lineStarts(s.bytes));
    this.stretches = scene.sources.map((s, file) => new Stretches(scene, file, this.starts[file].length));
    this.bad = scene.sources.map(() => new Map());
    for (const m of scene.messages) if (m.line && this.bad[m.file]) this.bad[m.file].set(m.line, m);
    this.file = 0;
    this.marked = 0;
    this.box.addEventListener("scroll", () => this.draw());
    this.rows.addEventListener("click", e => {
      const row = e.target.closest(".row");
      if (row) this.onPick(this.file, Number(row.dataset.line), this.stretches[this.file].of(Number(row.dataset.line)));
    });
    this.tabs();
    this.open(0);
  }

  length() { return this.starts.length ? this.starts[this.file].length - 1 : 0; }

  // A line of the file that is shown, counted from 0, without its end.
  line(i) {
    const {bytes} = this.scene.sources[this.file], begin = this.starts[this.file][i];
    let end = this.starts[this.file][i + 1];
    while (end > begin && (bytes[end - 1] === 10 || bytes[end - 1] === 13)) --end;
    return new TextDecoder().decode(bytes.subarray(begin, end));
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
    const lines = this.length();
    // A page has a greatest height: beyond it rows share it.
    this.scale = Math.max(1, lines * rowHeight / 8e6);
    this.space.style.height = lines * rowHeight / this.scale + "px";
    this.draw();
  }

  // Rows that fit, the greatest first row, and how far that is to scroll.
  room() {
    const lines = this.length(), fit = Math.ceil(this.box.clientHeight / rowHeight) + 2;
    return {fit, last: Math.max(0, lines - fit + 2), way: Math.max(1, lines * rowHeight / this.scale - this.box.clientHeight)};
  }

  firstRow() {
    const {last, way} = this.room();
    return Math.min(last, Math.floor(this.scale > 1 ? this.box.scrollTop / way * last : this.box.scrollTop / rowHeight));
  }

  draw() {
    const lines = this.length(), {fit} = this.room(), top = this.firstRow();
    this.rows.style.top = (this.scale > 1 ? this.box.scrollTop : top * rowHeight) + "px";
    this.rows.replaceChildren();
    for (let i = top; i < Math.min(lines, top + fit); ++i) {
      const row = document.createElement("div"), number = document.createElement("span"), message = this.bad[this.file].get(i + 1);
      row.className = "row" + (this.stretches[this.file].has(i + 1) ? " moves" : "") + (i + 1 === this.marked ? " marked" : "") +
        (message ? message.error ? " bad" : " odd" : "");
      row.dataset.line = i + 1;
      if (message) row.title = message.code + ": " + message.text;
      number.className = "number";
      number.textContent = i + 1;
      row.append(number, visible(this.line(i).slice(0, 400)));
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
