/** The front page of the site, with the engine: its figure moves, and its link opens the studio. */
import { expect, test } from "@playwright/test";

test("the figure of the front page moves by its slider", async ({ page }) => {
  await page.goto("/");
  const figure = page.locator("katydid-figure").first();
  const before = await figure.locator(".say").textContent();
  await figure.getByRole("button", { name: "Run the figure" }).click();
  await expect(figure).toHaveAttribute("data-state", "live");
  const slider = figure.locator("input[type=range]").nth(1);
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  await expect(figure.locator(".say")).not.toHaveText(before ?? "");
});

test("the front page leads to the studio", async ({ page }) => {
  await page.goto("/");
  await page.getByRole("link", { name: "Open the studio" }).click();
  await expect(page.getByRole("button", { name: "New definition" })).toBeVisible();
});
