/** What is done with the geometry of the selected objects. */
import { stat } from "node:fs/promises";

import { openText } from "./open";
import { expect, test } from "./test";

test("what is selected is baked, alone", async ({ page }) => {
  await openText(page, "two.kd", "katydid 1\na = Circle(_, 1)\nb = Circle(_, 2)\nc = Circle(_, 3)\n");
  const size = async (bake: () => Promise<void>): Promise<number> => {
    const [download] = await Promise.all([page.waitForEvent("download"), bake()]);
    expect(download.suggestedFilename()).toBe("two.3dm");
    return (await stat(await download.path())).size;
  };
  const all = await size(async () => {
    await page.keyboard.press("Control+Shift+E");
    await page.getByRole("button", { name: ".3dm" }).click();
  });
  await page.keyboard.press("Escape");
  await page.locator("#canvas").click({ position: { x: 300, y: 500 } });
  await page.keyboard.press("Control+f");
  await page.keyboard.type("b");
  await page.keyboard.press("Enter");
  const one = await size(() => page.keyboard.press("Insert"));
  expect(one).toBeLessThan(all);
});

test("previews are of all, of the selection, or of nothing", async ({ page }) => {
  await openText(page, "plane.kd", "katydid 1\nm = Mesh Plane(rectangle(plane((0, 0, 0)), -10..10, -10..10), 4, 4)\n");
  const colour = () => page.evaluate(() => window.__studio?.viewport?.pixel(200, 300));
  const run = async (command: string) => {
    await page.keyboard.press("Control+k");
    await page.keyboard.type(command);
    await page.keyboard.press("Enter");
  };
  await expect.poll(() => page.evaluate(() => window.__studio?.viewport?.stats()?.triangles ?? 0)).toBe(32);
  const seen = await colour();
  await run("Show no previews");
  await expect.poll(colour).not.toEqual(seen);
  const none = await colour();
  await run("Show previews of the selection only");
  await expect.poll(colour).toEqual(none);
  await page.locator("#canvas").click({ position: { x: 300, y: 500 } });
  await page.keyboard.press("Control+a");
  await expect.poll(colour).not.toEqual(none);
  await run("Show all previews");
  await page.keyboard.press("Escape");
  await expect.poll(colour).not.toEqual(none);
});
