/** The book without a server: its figures find the engine in a worker beside the page. */
import { expect, test } from "@playwright/test";

test("a figure of the book moves", async ({ page }) => {
  const faults: string[] = [];
  page.on("pageerror", (error) => faults.push(String(error)));
  await page.goto("/learn/V4/index.html");
  const figure = page.locator("katydid-figure").first();
  const begin = Date.now();
  await figure.getByRole("button").first().click();
  await expect(figure).toHaveAttribute("data-state", "live");
  await expect(figure).toHaveAttribute("data-solved", /[1-9]/);
  console.log(`first figure live after ${Date.now() - begin} ms`);
  const before = Number(await figure.getAttribute("data-solved"));
  const slider = figure.locator("input[type=range]").first();
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  await expect.poll(async () => Number(await figure.getAttribute("data-solved"))).toBeGreaterThan(before);
  await page.screenshot({ path: test.info().outputPath("figure.png") });
  expect(faults).toEqual([]);
});

test("two figures of a page have one engine", async ({ page }) => {
  await page.goto("/learn/C3/index.html");
  const figures = page.locator("katydid-figure");
  expect(await figures.count()).toBeGreaterThan(1);
  for (const figure of (await figures.all()).slice(0, 2)) {
    await figure.getByRole("button").first().click();
    await expect(figure).toHaveAttribute("data-solved", /[1-9]/);
  }
  expect(page.workers().length).toBeLessThanOrEqual(2);
});
