/** Ways into the studio that many tests take. */
import { expect, type Page } from "@playwright/test";

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

async function onWorkbench(page: Page): Promise<void> {
  await page.waitForURL(/document=/);
  await expect(page.getByRole("region", { name: "Canvas", exact: true })).toBeVisible();
  await expect(page.getByRole("status").filter({ hasText: /Solved|Solving/ })).toBeVisible();
}
