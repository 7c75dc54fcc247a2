// Somebody who has the file and nothing else: finds the diameter of a named hole, hides the borders, filters false lines by their
// confidence, and saves a DXF of what is left, which `cargo xtask web --test` hands to ezdxf.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { along, check, folder, open, polylines, saved, settled } from "./common.mjs";

/** The bore of plate.mjs. */
const DIAMETER = 1.4;

const strips = (page) => page.evaluate(() => window.lineament.report.strips.map(({ id, kind, confidence }) => ({ id, kind, confidence })));

export async function reader(browser) {
  const page = await open(browser, "plate.html");
  const all = await strips(page);
  await check("names a hole without patches, with diameter, axis and standard deviation", async () => {
    assert.equal(await page.evaluate(() => window.lineament.report.patches.length), 0);
    const row = page.getByRole("table").locator("tbody tr", { hasText: /^hole/ }).first();
    const cells = await row.locator("td").allInnerTexts();
    const [, value, sigma] = cells[0].match(/^([\d.]+) ± ([\d.]+)$/).map(Number);
    assert.ok(Math.abs(value - DIAMETER) < 0.01 && sigma > 0 && sigma < 0.01, cells[0]);
    assert.ok(cells.some((cell) => cell.endsWith("1.000")), String(cells));
    await row.locator("th button").click();
    const shown = await page.locator("#selection").innerText();
    for (const word of ["hole", "radius", "±", "axis", "centre"]) assert.ok(shown.includes(word), `${word} in ${shown}`);
    await page.keyboard.press("Escape");
    await page.keyboard.press("f");
  });
  await check("colours lines by confidence", async () => {
    await page.keyboard.press("p");
    const red = async () => {
      await settled(page);
      const { hits, total } = await along(page, "crease");
      return hits / total;
    };
    const all = await red();
    assert.ok(all > 0.98, `${all} of the creases red`);
    await page.selectOption("#line-colour", "confidence");
    // Most are sure, and none of these is red.
    const sure = await red();
    assert.ok(sure < 0.4, `${sure} of the creases red by confidence`);
    assert.ok(await page.locator(".shades").isVisible());
    await page.selectOption("#line-colour", "kind");
    assert.equal(await red(), all);
    await page.keyboard.press("p");
  });
  await check("hides the borders, filters false lines by confidence, and saves a DXF of the others", async () => {
    const creases = all.filter((s) => s.kind === "crease");
    assert.ok(creases.length > 10 && creases.length < all.length);
    await page.uncheck("#layer-borders");
    const least = "0.75";
    await page.locator("#confidence").fill(least);
    const left = creases.filter((s) => s.confidence >= Number(least));
    assert.ok(left.length > 8 && left.length < creases.length, `${left.length} of ${creases.length} creases`);
    const dxf = await saved(page, "dxf");
    assert.equal(polylines(dxf), left.length);
    assert.ok(!/POLYLINE\n8\nBORDER/.test(dxf) && /POLYLINE\n8\nCREASE/.test(dxf));
    writeFileSync(join(folder, "left.dxf"), dxf);
  });
  await check("has no error in the console, and asks for nothing", () => assert.deepEqual(page.faults, []));
  await page.context().close();
}
