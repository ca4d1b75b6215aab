/** Cameras with names, the turntable, and what is rendered. */
import { readFile } from "node:fs/promises";

import { isAccessible } from "./access";
import { openText } from "./open";
import { expect, test } from "./test";

const TEXT = "katydid 1\nbox = Domain Box(plane((0, 0, 0)), 0..4, 0..3, 0..2)\n";

/** What a film may take, in milliseconds; an action of the browser has less. */
const FILMED = 100_000;

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

test("one turn of the model is kept as a film, and the camera is back where it was", async ({ page }) => {
  await openText(page, "box.kd", TEXT);
  await page.getByRole("button", { name: "Cameras" }).click();
  const before = await corner(page);
  const download = page.waitForEvent("download", { timeout: FILMED });
  await page.getByRole("button", { name: "Film of a turn" }).click();
  await expect.poll(() => corner(page)).not.toEqual(before);
  const film = await download;
  expect(film.suggestedFilename()).toMatch(/^model\.(webm|mp4)$/);
  const bytes = await readFile((await film.path()) ?? "");
  expect(bytes.length).toBeGreaterThan(2_000);
  // The mark of EBML, which WebM is made of.
  if (film.suggestedFilename().endsWith("webm")) expect([...bytes.subarray(0, 4)]).toEqual([0x1a, 0x45, 0xdf, 0xa3]);
  await expect.poll(() => corner(page)).toEqual(before);
});

test("where the browser makes no films, the turn is kept as pictures", async ({ page }) => {
  // Seventy-two pictures, drawn and packed without a graphics card: small ones, and more time than an action has.
  test.slow();
  await page.setViewportSize({ width: 1280, height: 480 });
  await page.addInitScript(() => Reflect.deleteProperty(window, "MediaRecorder"));
  await openText(page, "box.kd", TEXT);
  await page.getByRole("button", { name: "Cameras" }).click();
  const download = page.waitForEvent("download", { timeout: FILMED });
  await page.getByRole("button", { name: "Film of a turn" }).click();
  const film = await download;
  expect(film.suggestedFilename()).toBe("model.zip");
  const bytes = await readFile((await film.path()) ?? "");
  expect(bytes.toString("latin1").match(/turn-\d\d\.png/g)?.length).toBe(2 * 72);
});
