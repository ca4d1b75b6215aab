import { isAccessible } from "./access";
import { openFromGallery } from "./open";
import { expect, test } from "./test";

for (const scheme of ["light", "dark"] as const) {
  test.describe(`in the ${scheme} theme`, () => {
    test.use({ colorScheme: scheme });

    test("the start page", async ({ page }) => {
      await page.goto("/");
      await expect(page.getByRole("button", { name: /^Anchor, vector, tip/ })).toBeVisible();
      await isAccessible(page);
    });

    test("the workbench with each panel", async ({ page }) => {
      await openFromGallery(page, /Anchor, vector, tip/);
      await isAccessible(page);
      for (const [keys, name] of [["O", "Outline"], ["M", "Problems"], ["D", "Data"]]) {
        await page.keyboard.press(`Control+Shift+${keys}`);
        await expect(page.getByRole("complementary", { name: name ?? "" })).toBeVisible();
        await isAccessible(page);
      }
    });

    test("the dialogs", async ({ page }) => {
      await openFromGallery(page, /Anchor, vector, tip/);
      for (const keys of ["Control+k", "?", "Control+,", "Control+Shift+S", "Control+Shift+E"]) {
        await page.keyboard.press(keys);
        await expect(page.getByRole("dialog")).toBeVisible();
        await isAccessible(page);
        await page.keyboard.press("Escape");
        await expect(page.getByRole("dialog")).toHaveCount(0);
      }
    });

    test("the player", async ({ page }) => {
      await openFromGallery(page, /Anchor, vector, tip/);
      await page.goto(`${page.url()}&player`);
      await expect(page.getByRole("complementary", { name: "Inputs" }).getByRole("slider").first()).toBeVisible();
      await isAccessible(page);
    });
  });
}
