// Opens pages of `arelem view` in headless Chromium and tells what is there, as JSON on standard output.
// usage: node look.mjs CHROMIUM FOLDER_OF_node_modules TASKS.json
//   TASKS.json: [{"page": FILE, "shot": FILE, "clicks": [location, ...], "rows": [line, ...], "run": [expression, ...]}, ...]
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
  await page.setViewport({width: 1280, height: 800});
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
  told.clicks = [];
  for (const location of task.clicks || []) {
    const at = await page.evaluate(i => {
      const {stage, scene} = window.arelem, box = stage.canvas.getBoundingClientRect();
      const place = k => { // halfway between two locations, on the screen
        const p = [0, 1, 2].map(a => (scene.places[3 * k + a] + scene.places[3 * k - 3 + a]) / 2 - stage.center[a]);
        return stage.camera.position.clone().set(...p).project(stage.camera);
      };
      const p = place(i);
      return [box.left + (p.x * 0.5 + 0.5) * box.width, box.top + (0.5 - p.y * 0.5) * box.height];
    }, location);
    await page.mouse.click(...at);
    told.clicks.push({marked: await marked(), readout: await page.$eval("#readout", e => e.textContent)});
  }
  told.rows = [];
  for (const line of task.rows || []) {
    await page.click(`.row[data-line="${line}"]`);
    told.rows.push(await page.evaluate(() => ({chosen: window.arelem.state.chosen, time: window.arelem.state.time})));
  }
  told.run = [];
  for (const expression of task.run || []) told.run.push(await page.evaluate(expression));
  await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
  const shot = await page.screenshot({encoding: "base64"});
  if (task.shot) writeFileSync(task.shot, Buffer.from(shot, "base64"));
  told.colors = await page.evaluate(async source => {
    const image = new Image();
    image.src = "data:image/png;base64," + source;
    await image.decode();
    const canvas = document.createElement("canvas"), stage = document.getElementById("canvas").getBoundingClientRect();
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
  }, shot);
  told.images = await page.evaluate(() => document.images.length);
  told.scripts = await page.evaluate(() => document.querySelectorAll("script[src], link[rel=stylesheet], iframe, object").length);
  await page.close();
  return told;
}

const told = [];
for (const task of JSON.parse(readFileSync(list, "utf8"))) told.push(await look(task));
await browser.close();
console.log(JSON.stringify(told));
