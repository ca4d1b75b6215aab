import { expect, test } from "@playwright/test";

import { isAccessible } from "../../e2e/access";

for (const dark of ["", "&dark"]) {
  test(`display modes are chosen by their pictures, with the keyboard too${dark ? " (dark)" : ""}`, async ({ page }) => {
    await page.goto(`/tests/viewport/page.html?scene=box${dark}`);
    const button = page.getByRole("button", { name: "Display", exact: true });
    await button.click();
    const modes = page.getByRole("radiogroup", { name: "Display" });
    await expect(modes.getByRole("radio")).toHaveCount(5);
    // Each picture is another.
    const pictures = await modes.locator("svg").evaluateAll((all) => all.map((each) => each.outerHTML));
    expect(new Set(pictures).size).toBe(5);
    await isAccessible(page);
    await modes.getByRole("radio", { name: "Ghosted" }).click();
    expect(await page.evaluate(() => window.test.settingsStore.getState().mode)).toBe("ghosted");
    await page.keyboard.press("ArrowDown");
    expect(await page.evaluate(() => window.test.settingsStore.getState().mode)).toBe("rendered");
    await page.keyboard.press("Escape");
    await expect(modes).toHaveCount(0);
    await expect(button).toBeFocused();
  });
}
