/** The Rhino model beside a definition, and geometry that is picked from it or drawn. */
import type { Locator, Page } from "@playwright/test";

import { isAccessible } from "./access";
import { openCanvas } from "./canvas";
import { writeModel } from "./model";
import { openText } from "./open";
import { expect, test } from "./test";

const MODEL = writeModel();

async function attach(page: Page): Promise<void> {
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Rhino model" }).click();
  await page.getByRole("button", { name: /Attach a model/ }).click();
  await (await chooser).setFiles(MODEL);
  await expect(page.getByRole("checkbox", { name: /Walls/ })).toBeVisible();
}

/** The objects in the picture: those of the document, and of layers. */
const drawn = (page: Page) => page.evaluate(() => window.__studio?.viewport?.stats()?.objects);

async function menuOf(page: Page, object: Locator, entry: RegExp): Promise<void> {
  await object.locator(".band, .name, .title").first().click({ button: "right" });
  await page.getByRole("menuitem", { name: entry }).click();
}

/** Where a point of the model is on the page. */
async function spot(page: Page, point: [number, number, number]): Promise<{ x: number; y: number }> {
  const at = await page.evaluate((point) => window.__studio?.viewport?.place(point), point);
  const box = await page.locator(".viewport-canvas").boundingBox();
  return { x: (box?.x ?? 0) + (at?.[0] ?? 0), y: (box?.y ?? 0) + (at?.[1] ?? 0) };
}

/** The same once the camera stands still: it moves to what has come. */
async function stillSpot(page: Page, point: [number, number, number]): Promise<{ x: number; y: number }> {
  let at = await spot(page, point);
  await expect
    .poll(async () => {
      const before = at;
      at = await spot(page, point);
      return Math.hypot(at.x - before.x, at.y - before.y);
    }, { intervals: [300] })
    .toBeLessThan(0.5);
  return at;
}

async function click(page: Page, point: [number, number, number]): Promise<void> {
  const { x, y } = await stillSpot(page, point);
  await page.mouse.move(x, y);
  await page.mouse.click(x, y);
}

test("the model is shown by layers, which can be hidden", async ({ page }, info) => {
  await openCanvas(page);
  await attach(page);
  await expect.poll(() => drawn(page)).toBe(3);
  await page.screenshot({ path: info.outputPath("layers.png") });
  await isAccessible(page);
  await page.getByRole("checkbox", { name: /Trees/ }).uncheck();
  await expect.poll(() => drawn(page)).toBe(2);
  await page.getByRole("checkbox", { name: "Show the model" }).uncheck();
  await expect.poll(() => drawn(page)).toBe(0);
  // Who comes back finds the model still there.
  await page.reload();
  await expect.poll(() => drawn(page)).toBe(3);
});

test("a model is taken away again", async ({ page }) => {
  await openCanvas(page);
  await attach(page);
  await expect.poll(() => drawn(page)).toBe(3);
  await page.getByRole("button", { name: "Detach the model" }).click();
  await expect.poll(() => drawn(page)).toBe(0);
  await expect(page.getByText("No Rhino model is attached.")).toBeVisible();
});

test("a curve is picked from the model and referred to", async ({ page }, info) => {
  await openText(page, "curve.kd", `katydid 1\nshape = Curve()\nlist = Panel(shape)\n\nlayout {\n    shape: 40 40\n    list: 200 40 [200 40 220 60]\n}\n`);
  const list = page.getByRole("group", { name: /^list/ });
  await attach(page);
  await page.keyboard.press("Escape");
  await menuOf(page, page.getByRole("group", { name: /^shape/ }), /^Set one curve/);
  const bar = page.getByRole("region", { name: /Set one curve/ });
  await expect(bar).toBeVisible();
  // The ball is no curve: it is refused in words, and the job goes on.
  await click(page, [0, 10, 3]);
  await expect(page.getByText(/is no Curve/)).toBeVisible();
  await expect(bar).toBeVisible();
  await click(page, [5, 0, 0]);
  await expect(bar).toHaveCount(0);
  await page.screenshot({ path: info.outputPath("picked.png") });
  await expect(list).toContainText("Line-like Curve");
  await page.keyboard.press("Control+Z");
  await expect(list).not.toContainText("Line-like Curve");
});

test("points are drawn by clicks and typed coordinates, and are one step for Undo", async ({ page }) => {
  await openText(page, "points.kd", `katydid 1\np = Point()\nlist = Panel(p)\n\nlayout {\n    p: 40 40\n    list: 200 40 [200 40 220 120]\n}\n`);
  const point = page.locator("[data-object]").first();
  await menuOf(page, point, /^Set multiple point/);
  const field = page.getByRole("textbox", { name: /Point/ });
  await expect(field).toBeFocused();
  for (const typed of ["1,2", "r1,1,1"]) {
    await field.fill(typed);
    await field.press("Enter");
  }
  const panel = page.getByRole("group", { name: /^list/ });
  await expect(panel).toContainText("{1, 2, 0}");
  // A point counts from the one before; each is a drawing of its own here, so there is none.
  await expect(page.getByRole("alert").filter({ hasText: "This is no point" })).toBeVisible();
  await field.fill("w4,5,6");
  await field.press("Enter");
  await expect(panel).toContainText("{4, 5, 6}");
  await field.press("Enter");
  await expect(field).toHaveCount(0);
  await page.keyboard.press("Control+Z");
  await expect(panel).not.toContainText("{");
  await page.keyboard.press("Control+Y");
  await expect(panel).toContainText("{4, 5, 6}");
});

test("a polyline snaps to the ends of what is there, and Enter ends it", async ({ page }, info) => {
  const text = `katydid 1\nbase = Line((0, 0, 0), (8, 0, 0))\nshape = Curve()\nsize = Length(shape)\nlist = Panel(size)\n\nlayout {\n    base: 40 160\n    shape: 40 40\n    size: 200 40\n    list: 300 40 [300 40 120 60]\n}\n`;
  await openText(page, "shape.kd", text);
  await menuOf(page, page.getByRole("group", { name: /^shape/ }), /^Set one curve/);
  await page.getByRole("radio", { name: "Polyline" }).click();
  await click(page, [0.05, 0, 0]);
  await expect(page.locator(".viewport-snap")).toHaveText("End");
  await click(page, [7.95, 0, 0]);
  const field = page.getByRole("textbox", { name: /Next point/ });
  await field.fill("r0,6");
  await field.press("Enter");
  await page.screenshot({ path: info.outputPath("polyline.png") });
  await field.press("Enter");
  // 8 along the line from end to end, and 6 up.
  await expect(page.getByRole("group", { name: /^list/ })).toContainText("14");
});

test("Escape leaves, and nothing is set", async ({ page }) => {
  await openText(page, "leave.kd", `katydid 1\nshape = Curve()\n\nlayout {\n    shape: 40 40\n}\n`);
  const shape = page.locator("[data-object]").first();
  await menuOf(page, shape, /^Set multiple curve/);
  await page.getByRole("radio", { name: "Circle" }).click();
  const field = page.locator(".viewport-picking input[type=text]");
  await field.fill("0,0");
  await field.press("Enter");
  await field.fill("5,0");
  await field.press("Enter");
  await expect(page.getByText("1 item", { exact: true })).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(field).toHaveCount(0);
  await expect.poll(() => drawn(page)).toBe(0);
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`what is drawn can be drawn by everybody (${colorScheme})`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await openText(page, "leave.kd", `katydid 1\nshape = Curve()\n\nlayout {\n    shape: 40 40\n}\n`);
    await page.locator("[data-object]").first().focus();
    await menuOf(page, page.locator("[data-object]").first(), /^Set one curve/);
    await isAccessible(page);
    // By the keyboard alone: a tool, two points, done.
    await page.getByRole("radio", { name: "Line", exact: true }).focus();
    await page.keyboard.press("Space");
    await expect(page.getByRole("textbox", { name: "Start of line" })).toBeFocused();
    await isAccessible(page);
    for (const typed of ["0,0", "3,4"]) {
      await page.keyboard.type(typed);
      await page.keyboard.press("Enter");
    }
    await expect(page.getByRole("region", { name: /Set one curve/ })).toHaveCount(0);
    await expect.poll(() => drawn(page)).toBe(1);
  });
}
