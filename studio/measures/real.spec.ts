import { existsSync } from "node:fs";

import { test, type Page } from "@playwright/test";

import { openFile } from "../e2e/open";
import { share, watch } from "./watch";

/** Definitions of others with some two hundred objects: sliders whose change is seen in the picture. */
const FOLDER = "../../shared/data/gh/baharmon__computational-design-library";
const FILES = ["02-visual-programming/fundamentals.gh", "09-waves/waves.gh"];

/** So many sliders of a file are dragged. */
const MOST = 10;

interface Found {
  input: number;
  solve: number;
}

for (const name of FILES) {
  test(`the sliders of ${name} are dragged`, async ({ page }) => {
    const file = `${FOLDER}/${name}`;
    test.skip(!existsSync(file), "the file is not here");
    test.setTimeout(600_000);
    await watch(page);
    await openFile(page, file);
    await page.waitForFunction(() => window.watched.drawn > 0);
    await page.getByRole("status").filter({ hasText: /^Solved/ }).waitFor();
    const all: Found[] = [];
    const sliders = await page.evaluate(() => window.watched.sliders);
    for (const id of sliders.slice(0, MOST)) {
      const found = await drag(page, id);
      if (found) all.push(found);
    }
    const beyond = all.map(({ input, solve }) => input - 2 * solve);
    const middle = (of: (found: Found) => number) => share(all.map(of), 0.5).toFixed(1);
    console.log(
      `${name}: ${all.length} sliders; medians: input to picture ${middle(({ input }) => input)} ms, solve ${middle(({ solve }) => solve)} ms,`,
      `beyond twice the solve ${share(beyond, 0.5).toFixed(1)} ms (nine in ten below ${share(beyond, 0.9).toFixed(1)}, worst ${share(beyond, 1).toFixed(1)})`,
    );
    const floor = await page.evaluate(() => Array.from({ length: 9 }, () => window.__studio?.viewport?.draw() ?? 0));
    console.log(`a picture alone takes ${share(floor, 0.5).toFixed(1)} ms`);
  });
}

/** Drags one slider by small steps; medians of the steps that the picture showed. */
async function drag(page: Page, id: string): Promise<Found | undefined> {
  await page.locator("#canvas").click({ position: { x: 5, y: 400 } });
  await page.keyboard.press("ControlOrMeta+f");
  await page.keyboard.type(id);
  await page.keyboard.press("Enter");
  await page.keyboard.press("ControlOrMeta+2");
  const slider = page.locator(`[data-object="${id}"]`).getByRole("slider").first();
  if (!(await slider.waitFor({ timeout: 3000 }).then(() => true, () => false))) return undefined;
  await page.waitForTimeout(700);
  const box = await slider.boundingBox();
  if (!box) return undefined;
  const [y, step] = [box.y + box.height / 2, box.width * 0.04];
  await page.mouse.move(box.x + box.width * 0.2, y);
  await page.mouse.down();
  const found: Found[] = [];
  for (let k = 0; k < 12; k++) {
    const before = await page.evaluate(() => window.watched.count);
    await page.mouse.move(box.x + box.width * 0.2 + step * (k + 1), y);
    const isShown = await page
      .waitForFunction((count) => window.watched.count > count && window.watched.isWhole(), before, { timeout: 600, polling: 5 })
      .then(() => true, () => false);
    const { input, drawn, took } = await page.evaluate(() => window.watched);
    if (isShown && drawn >= input) found.push({ input: drawn - input, solve: took });
    else if (found.length === 0 && k > 3) break;
    await page.waitForTimeout(60);
  }
  await page.mouse.up();
  await page.keyboard.press("ControlOrMeta+z");
  await page.waitForTimeout(300);
  const middle = (of: (found: Found) => number) => share(found.map(of), 0.5);
  return found.length > 2 ? { input: middle(({ input }) => input), solve: middle(({ solve }) => solve) } : undefined;
}
