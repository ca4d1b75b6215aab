/** The picture of the studio that README.md shows. */
import { stat } from "node:fs/promises";

import { modelSize, openFile } from "../e2e/open";
import { expect, test } from "../e2e/test";

/** Larger ones make the front page of the project slow. */
const LARGEST = 300_000;

test("the studio with the twisted tower", async ({ page }) => {
  await page.setViewportSize({ width: 1220, height: 700 });
  await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
  await openFile(page, "../examples/tower.kd");
  await expect.poll(async () => (await modelSize(page))?.[2] ?? 0).toBeGreaterThan(0);
  await expect(page.getByRole("status").filter({ hasText: /Solved/ })).toBeVisible();
  // What names are under the mouse, or how long a solve took, is no part of the picture.
  await page.mouse.move(640, 2);
  await page.waitForTimeout(1500);
  const path = "../docs/pictures/studio.png";
  await page.screenshot({ path });
  expect((await stat(path)).size).toBeLessThan(LARGEST);
});
