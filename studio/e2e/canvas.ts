/** What hands do on the canvas. */
import type { Locator, Page } from "@playwright/test";

import { openNew } from "./open";
import { expect } from "./test";

export type At = readonly [number, number];

/** An empty canvas: of the real studio, or of the page without a server when `CANVAS_PAGE` says where that is. */
export async function openCanvas(page: Page): Promise<void> {
  const alone = process.env.CANVAS_PAGE;
  if (alone) await page.goto(`${alone}${alone.includes("?") ? "&" : "?"}state=empty`);
  else await openNew(page);
  await expect(ground(page)).toBeVisible();
}

export function ground(page: Page): Locator {
  return page.getByRole("group", { name: "Definition", exact: true });
}

/** A place on the page, from the corner of the canvas. */
export async function spot(page: Page, [x, y]: At): Promise<{ x: number; y: number }> {
  const box = await ground(page).boundingBox();
  return { x: (box?.x ?? 0) + x, y: (box?.y ?? 0) + y };
}

/** Searches at a place and takes the first find, or the one of this name. The new object is given back. */
export async function place(page: Page, words: string, at: At, name?: string): Promise<Locator> {
  const before = await ids(page);
  const { x, y } = await spot(page, at);
  await page.mouse.dblclick(x, y);
  const field = page.getByRole("combobox", { name: "Search for a component" });
  await field.fill(words);
  const finds = page.getByRole("listbox", { name: "Search for a component" }).getByRole("option");
  await expect(finds.first()).toBeVisible();
  if (name === undefined) await page.keyboard.press("Enter");
  else await finds.filter({ hasText: name }).first().click();
  await expect(field).toHaveCount(0);
  return newest(page, before);
}

export async function ids(page: Page): Promise<string[]> {
  return await page.locator("[data-object]").evaluateAll((all) => all.map((one) => one.getAttribute("data-object") ?? ""));
}

/** The object that was not there before. */
export async function newest(page: Page, before: readonly string[]): Promise<Locator> {
  await expect.poll(async () => (await ids(page)).filter((id) => !before.includes(id)).length).toBeGreaterThan(0);
  const fresh = (await ids(page)).find((id) => !before.includes(id)) ?? "";
  return page.locator(`[data-object="${fresh}"]`);
}

export function grip(object: Locator, side: "input" | "output", index = 0): Locator {
  return object.locator(`.grip.${side}`).nth(index);
}

export async function centre(what: Locator): Promise<{ x: number; y: number }> {
  const box = await what.boundingBox();
  if (!box) throw new Error("It is not on the page");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Drags with the mouse in steps, as a hand does. */
export async function drag(page: Page, from: { x: number; y: number }, to: { x: number; y: number }, keys: string[] = []): Promise<void> {
  await page.mouse.move(from.x, from.y);
  for (const key of keys) await page.keyboard.down(key);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 4 });
  await page.mouse.move(to.x, to.y, { steps: 4 });
  await page.mouse.up();
  for (const key of keys) await page.keyboard.up(key);
}

/** Draws a wire between two grips. */
export async function wire(page: Page, from: Locator, to: Locator, keys: string[] = []): Promise<void> {
  await drag(page, await centre(from), await centre(to), keys);
}

export function wires(page: Page): Locator {
  return page.locator("[data-wire]");
}
