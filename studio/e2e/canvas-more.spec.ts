import type { Page } from "@playwright/test";

import { isAccessible } from "./access";
import { centre, drag, ground, newest, ids, openCanvas, place, spot } from "./canvas";
import { expect, test } from "./test";

/** The page without a server knows few components, and no help. */
const alone = Boolean(process.env.CANVAS_PAGE);

test.beforeEach(async ({ page }) => {
  await openCanvas(page);
});

const ring = (page: Page) => page.getByRole("menu", { name: "Ring of commands" });
const zoom = (page: Page) => page.getByRole("button", { name: /^Zoom, / });

test("a middle click opens the ring of commands, a middle drag pans", async ({ page }) => {
  const one = await place(page, "addition", [250, 180]);
  const before = await centre(one);
  const { x, y } = await spot(page, [420, 320]);
  await page.mouse.click(x, y);
  await page.mouse.click(x, y, { button: "middle" });
  await expect(ring(page)).toBeVisible();
  await expect(ring(page).getByRole("menuitem", { name: "Search for a component" })).toBeVisible();
  // The first sector is at the top, and what it searches for goes where the ring was opened.
  await page.mouse.click(x, y - 75);
  await expect(ring(page)).toHaveCount(0);
  await expect(page.getByRole("combobox", { name: "Search for a component" })).toBeFocused();
  await page.keyboard.press("Escape");
  await page.mouse.move(x, y);
  await page.mouse.down({ button: "middle" });
  await page.mouse.move(x + 40, y + 30, { steps: 4 });
  await page.mouse.up({ button: "middle" });
  await expect(ring(page)).toHaveCount(0);
  await expect.poll(async () => Math.round((await centre(one)).x - before.x)).toBe(40);
});

test("the ring on an object selects it and acts on it, by keyboard too", async ({ page }) => {
  const one = await place(page, "addition", [250, 200]);
  await page.mouse.click(...at(await spot(page, [480, 360])));
  await expect(one).not.toHaveClass(/selected/);
  const { x, y } = await centre(one);
  await page.mouse.click(x, y, { button: "middle" });
  await expect(one).toHaveClass(/selected/);
  await expect(ring(page)).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(ring(page)).toHaveCount(0);
  await page.keyboard.press("Shift+Space");
  await expect(ring(page)).toBeFocused();
  await isAccessible(page);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await expect(one).toHaveAttribute("data-look", "disabled");
});

test("handles around a selection line it up", async ({ page }) => {
  const one = await place(page, "addition", [200, 150]);
  const two = await place(page, "multiplication", [330, 260]);
  await ground(page).press("Control+a");
  const handle = page.getByRole("button", { name: "Align left" });
  await expect(handle).toBeVisible();
  await isAccessible(page);
  await handle.click();
  await expect.poll(async () => Math.round(((await one.boundingBox())?.x ?? 0) - ((await two.boundingBox())?.x ?? 1))).toBe(0);
  await page.mouse.click(...at(await spot(page, [480, 420])));
  await expect(handle).toHaveCount(0);
});

test("the zoom box zooms by percents and fits; views of the canvas are kept and gone back to", async ({ page }) => {
  await place(page, "addition", [250, 180]);
  await zoom(page).click();
  await page.getByRole("menuitemcheckbox", { name: "150 %" }).click();
  await expect(zoom(page)).toHaveText(/150 %/);
  await ground(page).focus();
  await page.keyboard.press("Control+Shift+V");
  const dialog = page.getByRole("dialog", { name: "Views of the canvas" });
  await dialog.getByRole("textbox").fill("Near the sum");
  await dialog.getByRole("button", { name: "Keep as a view" }).click();
  await expect(dialog.getByRole("button", { name: "Go to Near the sum" })).toBeVisible();
  await isAccessible(page);
  await page.keyboard.press("Escape");
  await zoom(page).click();
  await page.getByRole("menuitemcheckbox", { name: "50 %", exact: true }).click();
  await expect(zoom(page)).toHaveText(/^50 %/);
  await ground(page).focus();
  await page.keyboard.press("PageDown");
  await expect(zoom(page)).toHaveText(/150 %/);
  // They are kept by the browser.
  await page.reload();
  await page.getByRole("button", { name: "Views of the canvas" }).click();
  await expect(page.getByRole("menuitemcheckbox", { name: "Near the sum" })).toBeVisible();
});

test("F1 helps with the selected component", async ({ page }) => {
  if (alone) {
    const help = { guid: "", name: "Addition", nick: "A+B", help: "Adds.\nNumbers, above all.", inputs: [{ name: "A", kind: "Number" }] };
    await page.route("**/api/help**", (route) => route.fulfill({ json: help }));
  }
  await place(page, "addition", [250, 180]);
  await page.keyboard.press("F1");
  const dialog = page.getByRole("dialog", { name: "Addition" });
  await expect(dialog.getByRole("table", { name: "Inputs" })).toContainText("A");
  await isAccessible(page);
  await page.keyboard.press("Escape");
  await expect(dialog).toHaveCount(0);
});

test("while something is searched for all else is faint, and arrows point to what is out of sight", async ({ page }) => {
  const panel = await place(page, '"needle', [200, 160]);
  const sum = await place(page, "addition", [380, 160]);
  await ground(page).focus();
  await page.keyboard.press("F3");
  await page.keyboard.type("needle");
  await expect(panel).toHaveClass(/found/);
  await expect(sum).not.toHaveClass(/found/);
  await expect.poll(() => sum.evaluate((element) => Number(getComputedStyle(element).opacity))).toBeLessThan(0.5);
  await expect(page.locator(".found-arrows button")).toHaveCount(0);
  await page.mouse.move(...at(await spot(page, [300, 300])));
  for (let k = 0; k < 12; k++) await page.mouse.wheel(0, -120);
  await expect(page.locator(".found-arrows button")).toHaveCount(1);
  await page.keyboard.press("Escape");
  await expect(ground(page)).not.toHaveClass(/finding/);
});

test("Alt and a drag on the empty canvas make room, and Undo takes it back", async ({ page }) => {
  const one = await place(page, "addition", [160, 160]);
  const two = await place(page, "multiplication", [400, 160]);
  const [a, b] = [await centre(one), await centre(two)];
  const from = await spot(page, [280, 320]);
  await drag(page, from, { x: from.x + 70, y: from.y + 10 }, ["Alt"]);
  await expect.poll(async () => Math.round((await centre(two)).x - b.x)).toBe(70);
  expect(Math.round((await centre(one)).x - a.x)).toBe(0);
  await page.keyboard.press("Control+z");
  await expect.poll(async () => Math.round((await centre(two)).x - b.x)).toBe(0);
});

test("a right click selects what its menu is about", async ({ page }) => {
  const one = await place(page, "addition", [200, 160]);
  const two = await place(page, "multiplication", [400, 160]);
  await expect(two).toHaveClass(/selected/);
  const { x, y } = await centre(one);
  await page.mouse.click(x, y, { button: "right" });
  await page.getByRole("menuitem", { name: /^Delete\b(?! and)/ }).click();
  await expect(one).toHaveCount(0);
  await expect(two).toBeVisible();
});

test("a definition that is let go with Alt comes into this one; without, it is asked", async ({ page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await place(page, "addition", [200, 160]);
  await ground(page).press("Control+a");
  await page.keyboard.press("Control+c");
  await expect(page.getByText("1 object copied")).toBeAttached();
  const text = await page.evaluate(() => navigator.clipboard.readText());
  const before = await ids(page);
  await letGo(page, text, [420, 260], true);
  await expect(await newest(page, before)).toHaveClass(/selected/);
  test.skip(alone && !process.env.CANVAS_PAGE?.includes("workbench"), "the page without a server has no dialogs");
  await letGo(page, text, [420, 260], false);
  const dialog = page.getByRole("dialog", { name: "piece.ghx" });
  await isAccessible(page, dialog);
  await dialog.getByRole("button", { name: /^Insert as a group/ }).click();
  await expect(page.locator("[data-group]")).toContainText("piece");
  const there = await ids(page);
  await letGo(page, text, [420, 90], false);
  await dialog.getByRole("button", { name: /^Insert as a cluster/ }).click();
  await expect(await newest(page, there)).toHaveClass(/cluster/);
});

test("a colour is picked with its opacity, and all of it is one step for Undo", async ({ page }) => {
  test.skip(alone, "the page without a server has no swatch to place");
  const swatch = await place(page, "colour swatch", [250, 180]);
  const face = swatch.getByRole("button");
  const before = await face.getAttribute("aria-label");
  await face.click();
  const field = page.getByRole("textbox", { name: "Colour", exact: true });
  await field.fill("#10203040");
  await isAccessible(page);
  await page.getByRole("slider", { name: "Hue" }).focus();
  await page.keyboard.press("ArrowRight");
  await page.getByRole("button", { name: "OK", exact: true }).click();
  await expect(face).toHaveAttribute("aria-label", /#[0-9a-f]{6}40$/);
  await page.keyboard.press("Control+z");
  await expect(face).toHaveAttribute("aria-label", before ?? "");
});

function at({ x, y }: { x: number; y: number }): [number, number] {
  return [x, y];
}

/** Lets a file of this text go over the canvas, as a hand does that dragged it in from elsewhere. */
async function letGo(page: Page, text: string, place: readonly [number, number], altKey: boolean): Promise<void> {
  const { x, y } = await spot(page, place);
  await page.evaluate(
    ([words, clientX, clientY, alt]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([words], "piece.ghx"));
      const below = document.elementFromPoint(clientX, clientY);
      const how = { dataTransfer, clientX, clientY, altKey: alt, bubbles: true, cancelable: true };
      for (const type of ["dragover", "drop"]) below?.dispatchEvent(new DragEvent(type, how));
    },
    [text, x, y, altKey] as const,
  );
}
