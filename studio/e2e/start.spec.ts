/** Where one begins: pictures of what there is, and one definition that can be tried at once. */
import { isAccessible } from "./access";
import { modelSize } from "./open";
import { expect, test } from "./test";

test("an example is live on the start page, and opens as it was left", async ({ page }, info) => {
  await page.goto("/");
  const hero = page.getByRole("region", { name: "Twisted tower" });
  // 20 floors of 3.4.
  await expect.poll(async () => (await modelSize(page))?.[2]).toBe(68);
  await page.screenshot({ path: info.outputPath("start.png") });
  await hero.getByRole("spinbutton", { name: /height/ }).fill("5");
  await expect.poll(async () => (await modelSize(page))?.[2]).toBe(100);
  await hero.getByRole("button", { name: "Open it" }).click();
  await page.waitForURL(/document=/);
  await expect.poll(async () => (await modelSize(page))?.[2]).toBe(100);
});

test("definitions of the gallery have pictures before anybody opened them", async ({ page }) => {
  await page.goto("/");
  const tile = page.getByRole("button", { name: /^Attractor/ });
  await tile.scrollIntoViewIfNeeded();
  await expect.poll(() => tile.locator("img").evaluate((image: HTMLImageElement) => [image.complete, image.naturalWidth])).toEqual([true, 640]);
});

test("a definition and its model are dropped together", async ({ page }) => {
  const { writeModel } = await import("./model");
  const { readFileSync } = await import("node:fs");
  const model = readFileSync(writeModel()).toString("base64");
  await page.goto("/");
  await page.evaluate((model) => {
    const files = new DataTransfer();
    const bytes = Uint8Array.from(atob(model), (letter) => letter.charCodeAt(0));
    files.items.add(new File(["katydid 1\nshape = Curve()\n"], "shape.kd"));
    files.items.add(new File([bytes], "house.3dm"));
    dispatchEvent(new DragEvent("drop", { dataTransfer: files, bubbles: true, cancelable: true }));
  }, model);
  await page.waitForURL(/document=/);
  await expect(page.getByText("Model: house.3dm")).toBeVisible();
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`nothing on the start page stands in anybody's way (${colorScheme})`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await page.goto("/");
    await expect.poll(async () => (await modelSize(page))?.[2]).toBeGreaterThan(0);
    await isAccessible(page);
  });
}
