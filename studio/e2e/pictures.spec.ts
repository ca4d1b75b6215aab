/**
 * What the page looks like, at three widths and in both themes. The pictures have half the pixels of the page along each
 * side: letters that another machine draws a little otherwise look alike, and the files stay small. After a change that is
 * meant: `--update-snapshots`, and look at them.
 */
import type { Page } from "@playwright/test";

import { openFromGallery } from "./open";
import { expect, test } from "./test";

test.use({ deviceScaleFactor: 0.5, contextOptions: { reducedMotion: "reduce" } });

const SIZES = { 1440: [1440, 900], 1024: [1024, 768], 390: [390, 844] } as const;

const PAGES = {
  async start(page: Page) {
    await page.goto("/");
  },
  async workbench(page: Page) {
    await openFromGallery(page, /^Twisted tower/);
  },
  async player(page: Page) {
    await openFromGallery(page, /^Twisted tower/);
    await page.goto(`${page.url()}&player`);
  },
};

const PICTURES = [
  ["start", 1440, "light"],
  ["start", 390, "dark"],
  ["workbench", 1440, "light"],
  ["workbench", 1024, "dark"],
  ["player", 1024, "light"],
  ["player", 390, "dark"],
] as const;

for (const [name, width, colorScheme] of PICTURES) {
  test(`${name} at ${width} pixels, ${colorScheme}`, async ({ page }) => {
    const [, height] = SIZES[width];
    await page.setViewportSize({ width, height });
    await page.emulateMedia({ colorScheme });
    await PAGES[name](page);
    await expect.poll(() => page.evaluate(() => window.__studio?.viewport?.stats()?.objects)).toBe(2);
    // The fine picture of the model, which comes when the camera has rested a while.
    await page.waitForTimeout(600);
    await page.evaluate(() => window.__studio?.viewport?.draw());
    // The lists below depend on what other tests opened; times differ with each solve.
    const clip = { x: 0, y: 0, width, height: name === "start" ? Math.min(height, 560) : height };
    const mask = [page.getByText(/^Solved in/), page.locator(".tiles")];
    await expect(page).toHaveScreenshot(`${name}-${width}-${colorScheme}.png`, { clip, mask, scale: "device", maxDiffPixelRatio: 0.02, threshold: 0.25 });
  });
}
