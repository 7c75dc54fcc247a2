// Shared parts of the tests in a browser.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

export const [folder, executablePath] = process.argv.slice(2);
export const FLAGS = [
  "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
  "--disable-sync", "--force-device-scale-factor=1",
];
export const DRAWING = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
export const VIEW = { width: 1280, height: 860 };
export const written = (name) => readFileSync(join(folder, name), "utf8");
const url = (name) => pathToFileURL(join(folder, name)).href;

let failures = 0;

export const failed = () => failures;

/** Does what is tested, and says how it went. */
export async function check(name, act) {
  try {
    await act();
    console.log(`ok      ${name}`);
  } catch (error) {
    failures++;
    console.log(`FAILED  ${name}\n        ${String(error.stack ?? error).replaceAll("\n", "\n        ")}`);
  }
}

/** Opens a report without a network, and gathers what goes wrong in it. */
export async function open(browser, name, options = {}) {
  const context = await browser.newContext({ viewport: VIEW, acceptDownloads: true, offline: true, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(10_000);
  page.faults = [];
  page.on("console", (message) => message.type() === "error" && page.faults.push(message.text()));
  page.on("pageerror", (error) => page.faults.push(String(error)));
  page.on("request", (request) => !/^(file|data|blob):/.test(request.url()) && page.faults.push(request.url()));
  const start = Date.now();
  await page.goto(url(name));
  if (options.javaScriptEnabled !== false) {
    await page.waitForFunction(() => window.lineament?.stage.frames > 0 || document.getElementById("state")?.textContent.includes("could not"));
  }
  page.milliseconds = Date.now() - start;
  return page;
}

/** Waits until a frame of all that was asked for stands. */
export const settled = (page) => page.evaluate(() => new Promise((done) => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(done)), 350)));

/** Points along lines with their colour on the screen: how many have a pixel of that hue within two pixels. */
export function along(page, kind) {
  return page.evaluate((kind) => {
    const { report, state, stage } = window.lineament;
    const canvas = document.createElement("canvas");
    canvas.width = stage.canvas.width;
    canvas.height = stage.canvas.height;
    const draw = canvas.getContext("2d");
    draw.drawImage(stage.canvas, 0, 0);
    const { data } = draw.getImageData(0, 0, canvas.width, canvas.height);
    const hue = (x, y) => {
      for (let dy = -2; dy <= 2; dy++) for (let dx = -2; dx <= 2; dx++) {
        const at = 4 * ((Math.round(y) + dy) * canvas.width + Math.round(x) + dx);
        const red = data[at] - data[at + 2];
        if (kind === "crease" ? red > 60 : red < -60) return true;
      }
      return false;
    };
    let [hits, total] = [0, 0];
    for (const strip of report.strips.filter((s) => s.kind === kind)) {
      for (let i = 0; i < strip.points.length; i += 3) {
        const [x, y] = stage.project(strip.points[i], strip.points[i + 1], strip.points[i + 2]);
        total++;
        if (hue(x, y)) hits++;
      }
    }
    return { hits, total, kept: state.kept().length };
  }, kind);
}

/** The text of a file that a button saves. */
export async function saved(page, extension) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(`#save button:has-text("${extension.toUpperCase()}")`)]);
  assert.equal(download.suggestedFilename().split(".").pop(), extension);
  return readFileSync(await download.path(), "utf8");
}

/** The vertices of the polylines, in order: x,y,z. */
export const vertices = (dxf) => [...dxf.matchAll(/\nVERTEX\n8\n.*\n10\n(.*)\n20\n(.*)\n30\n(.*)\n/g)].map((found) => found.slice(1).join());
export const polylines = (dxf) => dxf.split("\n").filter((line) => line === "POLYLINE").length;
