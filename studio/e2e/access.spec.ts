import { isAccessible } from "./access";
import { grip, openCanvas, place, spot, wire } from "./canvas";
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
      for (const [keys, name] of [["O", "Outline"], ["M", "Problems"], ["D", "Data"]] as const) {
        await page.keyboard.press(`Control+Shift+${keys}`);
        const panel = page.getByRole("complementary", { name });
        await expect(panel).toBeVisible();
        await isAccessible(page, panel);
      }
    });

    test("the dialogs", async ({ page }) => {
      await openFromGallery(page, /Anchor, vector, tip/);
      const dialog = page.getByRole("dialog");
      for (const keys of ["Control+k", "?", "Control+,", "Control+Shift+S", "Control+Shift+E", "Control+Shift+K"]) {
        await page.keyboard.press(keys);
        await expect(dialog).toBeVisible();
        await isAccessible(page, dialog);
        await page.keyboard.press("Escape");
        await expect(dialog).toHaveCount(0);
      }
      await page.keyboard.press("Control+k");
      await page.keyboard.type("about katydid");
      await page.keyboard.press("Enter");
      await expect(page.getByRole("dialog", { name: "About Katydid" })).toBeVisible();
      await isAccessible(page, dialog);
    });

    test("the boxes of the canvas, and objects in every state", async ({ page }) => {
      await openCanvas(page);
      const slider = await place(page, "0<2<10", [150, 90]);
      const division = await place(page, "Division", [400, 90]);
      await place(page, '"a note', [150, 260]);
      await place(page, "~a remark", [400, 260]);
      await place(page, "Value List", [560, 260]);
      await place(page, "Boolean Toggle", [150, 340]);
      await wire(page, grip(slider, "output"), grip(division, "input", 0));
      // A division by nothing yet is a warning; one by zero an error.
      const zero = await place(page, "0<0<10", [150, 160]);
      await wire(page, grip(zero, "output"), grip(division, "input", 1));
      await page.keyboard.press("Control+a");
      await page.keyboard.press("Control+g");
      await isAccessible(page);

      await slider.locator("[data-editor]").dblclick();
      const editor = page.getByRole("dialog", { name: /^Settings of/ });
      await isAccessible(page, editor);
      await editor.press("Escape");
      const { x, y } = await spot(page, [560, 400]);
      await page.mouse.dblclick(x, y);
      await page.keyboard.type("add");
      const list = page.locator(".pick-list");
      await expect(list.getByRole("option").first()).toBeVisible();
      await isAccessible(page, list);
      await page.keyboard.press("Escape");
      await division.locator(".band").click({ button: "right" });
      await isAccessible(page, page.locator(".pop-menu"));
      await page.keyboard.press("Escape");
      await page.keyboard.press("F3");
      await page.keyboard.type("Division");
      await isAccessible(page, list);
      await page.keyboard.press("Enter");
      for (const keys of ["F1", "Control+Shift+V"]) {
        await page.keyboard.press(keys);
        await expect(page.getByRole("dialog")).toBeVisible();
        await isAccessible(page, page.getByRole("dialog"));
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
