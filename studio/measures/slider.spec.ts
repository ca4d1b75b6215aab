import { writeFileSync } from "node:fs";

import { expect, test } from "@playwright/test";

import { openFile } from "../e2e/open";
import { share, watch } from "./watch";

/** 300 objects that all hang on one slider: 60 circles divided, moved, and curves through the points. */
function threeHundred(): string {
  const lines = ["katydid 1", "radius = Number Slider(20.0, 1..100)"];
  for (let k = 1; k <= 60; k++) {
    lines.push(
      `f${k} = Operators/Multiplication(radius, ${k})`,
      `c${k} = Circle(_, f${k})`,
      `d${k} = Divide Curve(c${k}, 200)`,
      `m${k} = Move(d${k}.Points, (0, 0, ${k}))`,
      `i${k} = Interpolate(m${k})`,
    );
  }
  return `${lines.join("\n")}\n`;
}

test("a slider of three hundred objects is dragged", async ({ page }, info) => {
  const file = info.outputPath("three-hundred.kd");
  writeFileSync(file, threeHundred());
  await watch(page);
  await openFile(page, file);
  await page.waitForFunction(() => window.watched.drawn > 0);
  await page.locator("#canvas").click({ position: { x: 300, y: 400 } });
  await page.keyboard.press("ControlOrMeta+f");
  await page.keyboard.type("radius");
  await page.keyboard.press("Enter");
  await page.keyboard.press("ControlOrMeta+2");
  const slider = page.getByRole("slider", { name: /radius/ }).first();
  await slider.waitFor();
  await page.waitForTimeout(500);
  const box = (await slider.boundingBox())!;
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width * 0.2, y);
  await page.mouse.down();
  const [whole, beyond, solves, heard]: [number[], number[], number[], number[]] = [[], [], [], []];
  for (let k = 0; k < 60; k++) {
    const before = await page.evaluate(() => window.watched.count);
    await page.mouse.move(box.x + box.width * (0.2 + 0.01 * (k + 1)), y);
    await page
      .waitForFunction((count) => window.watched.count > count && window.watched.isWhole(), before, { timeout: 3000, polling: 5 })
      .catch(() => undefined);
    const { input, drawn, took, previews } = await page.evaluate(() => window.watched);
    if (drawn < input) continue;
    whole.push(drawn - input);
    solves.push(took);
    heard.push(previews - input);
    beyond.push(drawn - input - 2 * took);
    await page.waitForTimeout(60);
  }
  console.log(
    `input to picture: ${share(whole, 0.5).toFixed(1)} ms (95 %: ${share(whole, 0.95).toFixed(1)}), solve ${share(solves, 0.5).toFixed(1)} ms,`,
    `beyond twice the solve ${share(beyond, 0.5).toFixed(1)} ms (95 %: ${share(beyond, 0.95).toFixed(1)}), ${whole.length} changes`,
  );
  const floor = await page.evaluate(() => Array.from({ length: 9 }, () => window.__studio?.viewport?.draw() ?? 0));
  console.log(`of it until the geometry was heard of ${share(heard, 0.5).toFixed(1)} ms; a picture alone takes ${share(floor, 0.5).toFixed(1)} ms`);
  // As a hand drags, without waiting.
  const before = await page.evaluate(() => window.watched.count);
  const start = Date.now();
  for (let k = 0; k < 120; k++) {
    await page.mouse.move(box.x + box.width * (0.3 + 0.2 * Math.sin(k / 10)), y);
    await page.waitForTimeout(10);
  }
  const dragged = Date.now() - start;
  const frames = (await page.evaluate(() => window.watched.count)) - before;
  const { input } = await page.evaluate(() => window.watched);
  await page.waitForTimeout(1500);
  const last = await page.evaluate(() => window.watched);
  await page.mouse.up();
  console.log(`dragged for ${dragged} ms: ${frames} pictures; the last after ${(last.drawn - input).toFixed(0)} ms`);
  expect(last.drawn).toBeGreaterThan(0);
});
