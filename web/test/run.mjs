// The report of the bracket in a browser: run.mjs FOLDER BROWSER, with bracket.html and bracket.csv as `extract` writes them in one run,
// stack.html as `report --slices` does, and plate.html as `extract` writes it of plate.mjs. Prints a line a check; ends
// with 1 if one fails.
import { chromium } from "playwright-core";
import assert from "node:assert/strict";
import { DRAWING, FLAGS, along, check, executablePath, failed, open, polylines, saved, settled, vertices, written } from "./common.mjs";
import { reader } from "./reader.mjs";

/** The middle of a line in sight, on the screen and on the page, farther from all other lines than the reach of a pick. */
function free(page, wanted = () => true) {
  return page.evaluate((wanted) => {
    const { report, stage } = window.lineament;
    const fits = new Function(`return ${wanted}`)();
    const flat = report.strips.map((s) => {
      const out = [];
      for (let i = 0; i < s.points.length; i += 3) out.push(stage.project(s.points[i], s.points[i + 1], s.points[i + 2]));
      return out;
    });
    const nearest = Math.min(...flat.flat().map((p) => p[2]));
    for (const strip of report.strips.filter(fits)) {
      for (const p of flat[strip.id].slice(2, -2).sort((a, b) => a[2] - b[2])) {
        const clear = flat.every((other, id) => id === strip.id || other.every((q) => Math.hypot(q[0] - p[0], q[1] - p[1]) > 10));
        if (clear && p[2] < nearest + 0.6 * report.radius) return { id: strip.id, x: p[0], y: p[1], length: strip.length };
      }
    }
    return null;
  }, wanted.toString());
}

async function bracket(browser) {
  const page = await open(browser, "bracket.html");
  await check(`opens from disk (${page.milliseconds} ms)`, async () => {
    assert.equal(await page.locator("#scene").count(), 1);
    assert.ok(!(await page.locator("#picture").isVisible()));
  });
  await check("saves the CSV that the program writes, byte for byte, and a DXF with the same points", async () => {
    assert.equal(await saved(page, "csv"), written("bracket.csv"));
    const points = written("bracket.csv").trim().split("\n").slice(1).map((row) => row.split(",").slice(4).join());
    assert.deepEqual(vertices(await saved(page, "dxf")), points);
  });
  await check("draws the lines where they are", async () => {
    await page.keyboard.press("p"); // The lines alone: none is hidden.
    await settled(page);
    const { hits, total } = await along(page, "crease");
    assert.ok(total > 100 && hits > 0.98 * total, `${hits} of ${total}`);
    await page.uncheck("#layer-creases");
    await settled(page);
    assert.ok((await along(page, "crease")).hits < 0.02 * total);
    await page.check("#layer-creases");
    await page.keyboard.press("p");
  });
  await check("shows a line under the mouse, and keeps it on a click", async () => {
    await settled(page);
    const line = await free(page);
    const box = await page.locator("#scene").boundingBox();
    await page.mouse.move(box.x + line.x, box.y + line.y);
    await page.waitForFunction((id) => window.lineament.state.hovered === id, line.id);
    assert.ok(await page.locator("#label").isVisible());
    await page.mouse.click(box.x + line.x, box.y + line.y);
    assert.equal(await page.evaluate(() => window.lineament.state.picked), line.id);
    const shown = await page.locator("#selection").innerText();
    const length = parseFloat(shown.match(/length\s+([\d.]+)/)[1]);
    assert.ok(Math.abs(length - line.length) < 1e-3 * line.length, `${length} against ${line.length}`);
    await page.keyboard.press("Escape");
  });
  await check("filters by length, and saves what is left", async () => {
    await page.locator("#length").fill("0.9");
    const kept = await page.evaluate(() => window.lineament.report.strips.filter((s) => s.length >= window.lineament.state.length).length);
    assert.ok(kept > 0 && kept < (await page.evaluate(() => window.lineament.report.strips.length)));
    assert.match(await page.locator("#kept").innerText(), new RegExp(`^${kept} of`));
    assert.equal(polylines(await saved(page, "dxf")), kept);
    assert.equal((await saved(page, "svg")).split("<path").length - 1, kept);
    await page.locator("#length").fill("0");
  });
  await check("sorts the table, and picks in it", async () => {
    const table = page.getByRole("table");
    await table.getByRole("button", { name: "Diameter", exact: true }).click();
    const values = (await table.locator("tbody tr td:nth-child(2)").allInnerTexts()).map(parseFloat);
    assert.ok(values.length > 1 && values.every((v, i) => i === 0 || v >= values[i - 1]), String(values));
    assert.equal(await table.locator("th[aria-sort=ascending]").count(), 1);
    await table.locator("tbody th button").first().click();
    assert.equal(await table.locator("tr[aria-selected=true]").count(), 1);
    assert.match(await page.locator("#selection").innerText(), /diameter/);
    await page.keyboard.press("Escape");
    await page.keyboard.press("f");
  });
  await check("takes a line out, and brings it back", async () => {
    const all = await page.evaluate(() => window.lineament.report.strips.length);
    await page.getByRole("table").locator("tbody th button").first().click();
    await page.keyboard.press("x");
    assert.match(await page.locator("#kept").innerText(), new RegExp(`^${all - 1} of ${all} `));
    assert.equal(polylines(await saved(page, "dxf")), all - 1);
    await page.getByRole("button", { name: "Bring back 1" }).click();
    assert.match(await page.locator("#kept").innerText(), new RegExp(`^${all} of`));
    await page.keyboard.press("Escape");
    await page.keyboard.press("f");
  });
  await check("measures between two lines", async () => {
    await settled(page);
    const box = await page.locator("#scene").boundingBox();
    const first = await free(page);
    const second = await free(page, `(s) => s.id !== ${first.id}`);
    await page.keyboard.press("m");
    for (const line of [first, second]) await page.mouse.click(box.x + line.x, box.y + line.y);
    const shown = await page.locator("#selection").innerText();
    const least = await page.evaluate(([a, b]) => {
      const points = (id) => window.lineament.report.strips[id].points;
      let best = Infinity;
      for (let i = 0; i < points(a).length; i += 3) for (let j = 0; j < points(b).length; j += 3) {
        best = Math.min(best, Math.hypot(...[0, 1, 2].map((k) => points(a)[i + k] - points(b)[j + k])));
      }
      return best;
    }, [first.id, second.id]);
    const found = parseFloat(shown.match(/least distance\s+([\d.]+)/)[1]);
    assert.ok(found <= least + 1e-3 && found >= 0.9 * least - 1e-3, `${found} against ${least} between the points`);
    await page.keyboard.press("Escape");
  });
  await check("turns, zooms, and changes its views by keys", async () => {
    for (const key of ["1", "2", "3", "4", "5", "6", "7", "o", "ArrowLeft", "ArrowUp", "+", "-", "Shift+ArrowRight", "t", "f", "o", "t"]) {
      const before = await page.evaluate(() => window.lineament.stage.frames);
      await page.keyboard.press(key);
      await page.waitForFunction((before) => window.lineament.stage.frames > before, before);
    }
  });
  await check("has no error in the console, and asks for nothing", () => assert.deepEqual(page.faults, []));
  await page.context().close();
}

async function stack(browser) {
  const page = await open(browser, "stack.html");
  await check(`a stack of sections opens (${page.milliseconds} ms)`, () => assert.ok(page.milliseconds < 60_000));
  await check("names holes", async () => {
    assert.ok((await page.locator("tbody th button:has-text('hole')").count()) > 0);
  });
  await check("drags a plane through the cloud, with its section", async () => {
    await page.locator("summary:has-text('Section plane')").click();
    await page.selectOption("#axis", "3");
    await page.locator("#at").fill("500");
    const first = await page.locator("#panel canvas + p").innerText();
    assert.match(first, /slice \d+ at .*contour/);
    await page.locator("#at").fill("200");
    assert.notEqual(await page.locator("#panel canvas + p").innerText(), first);
  });
  await check("lists the features of the slices", async () => {
    await page.getByRole("button", { name: /^Features of the slices/ }).click();
    assert.ok((await page.locator("tbody tr").count()) > 0);
  });
  await check("has no error in the console, and asks for nothing", () => assert.deepEqual(page.faults, []));
  await page.context().close();
}

async function without(args, options, name) {
  const browser = await chromium.launch({ executablePath, args: [...FLAGS, ...args] });
  await check(name, async () => {
    const page = await open(browser, "bracket.html", options);
    assert.ok(await page.locator("#picture img").isVisible());
    assert.ok(await page.locator("#picture img").evaluate((img) => img.naturalWidth > 0));
  });
  await browser.close();
}

const browser = await chromium.launch({ executablePath, args: [...FLAGS, ...DRAWING] });
await bracket(browser);
await stack(browser);
await reader(browser);
await browser.close();
await without(DRAWING, { javaScriptEnabled: false }, "shows a picture where scripts are off");
await without(["--disable-3d-apis"], {}, "shows a picture where there is no WebGL");
process.exit(failed() ? 1 : 0);
