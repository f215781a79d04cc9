// Opens pages of `arelem view` in headless Chromium and tells what is there, as JSON on standard output.
// usage: node look.mjs CHROMIUM FOLDER_OF_node_modules TASKS.json
//   TASKS.json: [{"page": FILE, "shot": FILE, "size": [width, height], "clicks": [location, ...], "rows": [line, ...], "run": [expression, ...],
//                 "steps": [{"key": K} or {"on": [location, share of its move]} or {"at": [x, y] of the canvas, from 0 to 1}
//                           or {"press": selector} or {"chart": share} or {"until": expression} or {"colors": true}
//                           or {"get": expression}, ...]}, ...]
import {readFileSync, writeFileSync} from "node:fs";
import {createRequire} from "node:module";
import {pathToFileURL} from "node:url";

const [chromium, modules, list] = process.argv.slice(2);
const main = createRequire(modules + "/").resolve("puppeteer-core");
const {default: puppeteer} = await import(pathToFileURL(main));
const browser = await puppeteer.launch({
  executablePath: chromium, headless: true, protocolTimeout: 600000, timeout: 120000,
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
});

async function look(task) {
  const page = await browser.newPage(), told = {problems: [], requests: []};
  const [width, height] = task.size || [1280, 800];
  await page.setViewport({width, height});
  page.on("console", m => { if (m.type() === "error") told.problems.push(m.text()); });
  page.on("pageerror", e => told.problems.push(String(e.message)));
  page.on("request", r => { if (!/^(file|data|blob):/.test(r.url())) told.requests.push(r.url()); });
  const begun = Date.now();
  await page.goto(pathToFileURL(task.page).href, {waitUntil: "domcontentloaded", timeout: 300000});
  await page.waitForFunction("window.arelem && window.arelem.ready", {timeout: 300000});
  told.seconds = (Date.now() - begun) / 1000;
  const marked = () => page.evaluate(() => {
    const row = document.querySelector(".row.marked");
    return row ? {line: Number(row.dataset.line), text: row.textContent} : null;
  });
  const onScreen = (location, share) => page.evaluate((i, t) => { // a place of the move to a location
    const {stage, scene} = window.arelem, box = stage.canvas.getBoundingClientRect();
    const q = [0, 1, 2].map(a => t * scene.places[3 * i + a] + (1 - t) * scene.places[3 * i - 3 + a] - stage.center[a]);
    const p = stage.camera.position.clone().set(...q).project(stage.camera);
    return [box.left + (p.x * 0.5 + 0.5) * box.width, box.top + (0.5 - p.y * 0.5) * box.height];
  }, location, share);
  told.clicks = [];
  for (const location of task.clicks || []) {
    await page.mouse.click(...await onScreen(location, 0.5));
    told.clicks.push({marked: await marked(), readout: await page.$eval("#readout", e => e.textContent)});
  }
  told.rows = [];
  for (const line of task.rows || []) {
    await page.click(`.row[data-line="${line}"]`);
    told.rows.push(await page.evaluate(() => ({chosen: window.arelem.state.chosen, time: window.arelem.state.time})));
  }
  told.run = [];
  for (const expression of task.run || []) told.run.push(await page.evaluate(expression));
  told.steps = [];
  for (const step of task.steps || []) {
    let result = null;
    const within = async (selector, x, y) => {
      const box = await page.$eval(selector, e => { const b = e.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; });
      return [box[0] + x * box[2], box[1] + y * box[3]];
    };
    if (step.key) await page.keyboard.press(step.key);
    if (step.on) await page.mouse.click(...await onScreen(...step.on));
    if (step.at) await page.mouse.click(...await within("#canvas", ...step.at));
    if (step.press) await page.click(step.press);
    if (step.chart) await page.mouse.click(...await within("#charts", step.chart, 0.5));
    if (step.until) await page.waitForFunction(step.until, {timeout: 120000, polling: 50});
    if (step.colors) result = await countColors(page, "canvas");
    if (step.charts) result = await countColors(page, "charts");
    if (step.get) result = await page.evaluate(step.get);
    told.steps.push(result);
  }
  told.colors = await countColors(page, "canvas", task.shot);
  told.images = await page.evaluate(() => document.images.length);
  told.scripts = await page.evaluate(() => document.querySelectorAll("script[src], link[rel=stylesheet], iframe, object").length);
  await page.close();
  return told;
}

// How often each color, of four bits a channel, stands in a part of the page.
async function countColors(page, id, file) {
  await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
  const shot = await page.screenshot({encoding: "base64"});
  if (file) writeFileSync(file, Buffer.from(shot, "base64"));
  return page.evaluate(async (source, part) => {
    const image = new Image();
    image.src = "data:image/png;base64," + source;
    await image.decode();
    const canvas = document.createElement("canvas"), stage = document.getElementById(part).getBoundingClientRect();
    canvas.width = stage.width;
    canvas.height = stage.height;
    const g = canvas.getContext("2d");
    g.drawImage(image, -stage.left, -stage.top);
    const pixels = g.getImageData(0, 0, canvas.width, canvas.height).data, count = {};
    for (let i = 0; i < pixels.length; i += 4) {
      const key = [pixels[i], pixels[i + 1], pixels[i + 2]].map(v => (v >> 4).toString(16)).join("");
      count[key] = (count[key] || 0) + 1;
    }
    return count;
  }, shot, id);
}

const told = [];
for (const task of JSON.parse(readFileSync(list, "utf8"))) told.push(await look(task));
await browser.close();
console.log(JSON.stringify(told));
