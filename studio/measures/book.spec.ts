import { existsSync } from "node:fs";

import { test, type CDPSession, type Page } from "@playwright/test";

import { share, watch } from "./watch";

const BOOK = process.env.KATYDID_BOOK ?? "../../shared/data/gh/the-book/TheEssentialMathematics_3rdEdition.gh";

test("the book's own file is opened, moved and zoomed", async ({ page }) => {
  test.skip(!existsSync(BOOK), "the book's file is not here");
  await watch(page);
  await page.goto("/");
  const start = Date.now();
  await page.locator("input[type=file]").setInputFiles(BOOK);
  await page.waitForURL(/document=/);
  await page.waitForFunction(() => document.querySelector("canvas.far, [data-object]"));
  const shown = Date.now() - start;
  await page.waitForFunction(() => window.watched.drawn > 0);
  const drawn = Date.now() - start;
  await page.getByRole("status").filter({ hasText: /^Solved/ }).waitFor();
  console.log(`on the canvas after ${shown} ms, the first geometry after ${drawn} ms, solved after ${Date.now() - start} ms`);
  await page.waitForTimeout(3000);
  await page.screenshot({ path: "test-results/book.png" });
  const cdp = await page.context().newCDPSession(page);
  await cdp.send("Performance.enable");
  await pan(page, cdp, "all of it", 0);
  await pan(page, cdp, "zoomed in 6 times", 6);
  await zoomTillFaces(page);
  await pan(page, cdp, "as soon as objects have their faces", 0);
  await pan(page, cdp, "zoomed in 5 times more", 5);
  await page.screenshot({ path: "test-results/book-near.png" });
  await drag(page, cdp);
});

/** Zooms in on the middle until objects are drawn with their faces. */
async function zoomTillFaces(page: Page): Promise<void> {
  const box = (await page.getByRole("group", { name: "Definition", exact: true }).boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  for (let k = 0; k < 60 && (await page.locator(".react-flow__node").count()) === 0; k++) {
    await page.mouse.wheel(0, -120);
    await page.waitForTimeout(80);
  }
}

/** Zooms by the wheel, then moves the canvas by the right button, as hands do; prints the cost of a frame. */
async function pan(page: Page, cdp: CDPSession, what: string, zoom: number): Promise<void> {
  const box = (await page.getByRole("group", { name: "Definition", exact: true }).boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  for (let k = 0; k < zoom; k++) {
    await page.mouse.wheel(0, -120);
    await page.waitForTimeout(50);
  }
  await page.waitForTimeout(1000);
  await move(page, cdp, what, [x, y], "right");
}

/** Drags a component, zoomed in to it; prints the cost of a frame. */
async function drag(page: Page, cdp: CDPSession): Promise<void> {
  await page.locator("#canvas").click({ position: { x: 5, y: 400 } });
  await page.keyboard.press("ControlOrMeta+f");
  await page.keyboard.type("Unit X");
  await page.keyboard.press("Enter");
  await page.keyboard.press("ControlOrMeta+2");
  await page.waitForTimeout(1500);
  const place = await page.evaluate(() => {
    const boxes = [...document.querySelectorAll(".react-flow__node-k-component")].map((node) => node.getBoundingClientRect());
    const places = boxes.map(({ left, top, width, height }): [number, number] => [left + width / 2, top + height / 2]);
    return places.find((at) => document.elementFromPoint(...at)?.closest(".react-flow__node-k-component"));
  });
  if (place) await move(page, cdp, "a component dragged", place, "left");
}

async function move(page: Page, cdp: CDPSession, what: string, [x, y]: [number, number], button: "left" | "right"): Promise<void> {
  await page.mouse.move(x, y);
  const before = await metrics(cdp);
  await page.evaluate(() => window.frameTimes.start());
  await page.mouse.down({ button });
  for (let k = 0; k < 40; k++) {
    const away = k < 20 ? k : 40 - k;
    const by = button === "right" ? 24 : 6;
    await page.mouse.move(x + away * by, y + (away * by) / 2);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
  }
  await page.mouse.up({ button });
  const frames = await page.evaluate(() => window.frameTimes.stop());
  const after = await metrics(cdp);
  const each = (name: string) => (((after[name]! - before[name]!) * 1000) / 40).toFixed(1);
  const count = await page.evaluate(() => document.querySelectorAll(".react-flow__node").length);
  const [half, most] = [share(frames, 0.5), share(frames, 0.95)].map((value) => value.toFixed(1));
  const late = frames.filter((length) => length > 33).length;
  console.log(
    `${what}: ${count} nodes, main thread ${each("TaskDuration")} ms a frame, script ${each("ScriptDuration")} ms;`,
    `a frame takes ${half} ms, 95th percentile ${most} ms, ${late} of ${frames.length} over 33 ms`,
  );
}

async function metrics(cdp: CDPSession): Promise<Record<string, number>> {
  const { metrics } = await cdp.send("Performance.getMetrics");
  return Object.fromEntries(metrics.map(({ name, value }) => [name, value]));
}
