/** Cameras with names, the turntable, and what is rendered. */
import { isAccessible } from "./access";
import { openText } from "./open";
import { expect, test } from "./test";

const TEXT = "katydid 1\nbox = Domain Box(plane((0, 0, 0)), 0..4, 0..3, 0..2)\n";

/** Where a corner of the box is in the picture. */
const corner = (page: import("@playwright/test").Page) => page.evaluate(() => window.__studio?.viewport?.place([4, 3, 2])?.map(Math.round));

test("a camera is saved by name, comes back after the page was loaded again, and is removed", async ({ page }) => {
  await openText(page, "box.kd", TEXT);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.getByRole("combobox", { name: "View", exact: true }).selectOption("front");
  const front = await corner(page);
  await page.getByRole("button", { name: "Cameras" }).click();
  await page.getByRole("textbox", { name: "Name of this view" }).fill("Entrance");
  await page.getByRole("button", { name: "Save", exact: true }).last().click();
  await isAccessible(page);
  await page.reload();
  await expect.poll(() => corner(page)).not.toEqual(front);
  await page.getByRole("button", { name: "Cameras" }).click();
  await page.getByRole("button", { name: "Entrance", exact: true }).click();
  await expect.poll(() => corner(page)).toEqual(front);
  await page.getByRole("button", { name: "Remove Entrance" }).click();
  await expect(page.getByText("No camera has a name yet.")).toBeVisible();
});

test("the turntable turns until a hand takes the model, and never where less motion is asked for", async ({ page }) => {
  await openText(page, "box.kd", TEXT);
  await page.getByRole("button", { name: "Cameras" }).click();
  const before = await corner(page);
  await page.getByRole("checkbox", { name: "Turntable" }).check();
  await expect.poll(() => corner(page)).not.toEqual(before);
  await page.locator(".viewport-canvas").click({ button: "right", position: { x: 60, y: 60 } });
  const stopped = await corner(page);
  await page.waitForTimeout(300);
  expect(await corner(page)).toEqual(stopped);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.getByRole("button", { name: "Cameras" }).click();
  await expect(page.getByRole("checkbox", { name: "Turntable" })).toHaveCount(0);
});

test("what is rendered stands under a sky, with a shadow on the ground, and is darker in its corners", async ({ page }, info) => {
  const text = "katydid 1\nfloor = Domain Box(plane((0, 0, 0)), -6..6, -6..6, -1..0) hidden\nwall = Domain Box(plane((0, 0, 0)), -6..6, 5..6, 0..8) hidden\nshown = Custom Preview([floor, wall], rgb(200, 200, 200))\n";
  await openText(page, "corner.kd", text);
  await page.getByRole("button", { name: "Display: rendered" }).click();
  const light = async (point: [number, number, number]) => {
    const [x, y] = (await page.evaluate((point) => window.__studio?.viewport?.place(point), point)) ?? [0, 0];
    const colour = await page.evaluate(([x, y]) => window.__studio?.viewport?.pixel(x!, y!), [x, y]);
    return (colour?.[0] ?? 0) + (colour?.[1] ?? 0) + (colour?.[2] ?? 0);
  };
  await expect.poll(() => light([0, 0, 0])).toBeGreaterThan(0);
  const [open, inCorner] = [await light([0, -3, 0]), await light([0, 4.9, 0])];
  expect(inCorner).toBeLessThan(open - 25);
  await page.screenshot({ path: info.outputPath("rendered.png") });
});
