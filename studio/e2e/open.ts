/** Ways into the studio that many tests take. */
import type { Page } from "@playwright/test";

import type {} from "../src/viewport/current";
import { expect } from "./test";

/** A new, empty definition on the workbench. */
export async function openNew(page: Page): Promise<void> {
  await page.goto("/");
  await page.getByRole("button", { name: "New definition" }).click();
  await onWorkbench(page);
}

/** A definition of the book, by the beginning of its title in the gallery. */
export async function openFromGallery(page: Page, title: RegExp): Promise<void> {
  await page.goto("/");
  await page.getByRole("main").getByRole("button", { name: title }).first().click();
  await onWorkbench(page);
}

/** Sends a file of this machine to the studio, as one who chooses it in the page does. */
export async function openFile(page: Page, path: string): Promise<void> {
  await page.goto("/");
  await page.locator("input[type=file]").setInputFiles(path);
  await onWorkbench(page);
}

/** Opens a definition that is written down here, as a file that is chosen in the page. */
export async function openText(page: Page, name: string, text: string): Promise<void> {
  await page.goto("/");
  await page.locator("input[type=file]").setInputFiles({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
  await onWorkbench(page);
}

export async function onWorkbench(page: Page): Promise<void> {
  await page.waitForURL(/document=/);
  await expect(page.getByRole("region", { name: "Canvas", exact: true })).toBeVisible();
  await expect(page.getByRole("status").filter({ hasText: /Solved|Solving/ })).toBeVisible();
}

/** How far the model reaches along x, y and z, rounded; nothing where there is none. */
export async function modelSize(page: Page): Promise<number[] | null> {
  return await page.evaluate(() => {
    const bounds = window.__studio?.viewport?.stats()?.bounds;
    return bounds ? [0, 1, 2].map((axis) => Math.round((bounds[1][axis] ?? 0) - (bounds[0][axis] ?? 0))) : null;
  });
}
