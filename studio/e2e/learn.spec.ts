/** The pages of the book, as the studio serves them at `/learn`. */
import { readFileSync } from "node:fs";

import type { Page } from "@playwright/test";

import { isAccessible } from "./access";
import { expect, test } from "./test";

interface Figure extends HTMLElement {
  start(): Promise<unknown>;
  items(name: string): Promise<unknown[]>;
}

type Expected = { expect: Record<string, unknown[]> };

const rows = ["V4", "C9"] as const;

function expected(row: string): Record<string, unknown[]> {
  return (JSON.parse(readFileSync(new URL(`../../book/${row}/expected.json`, import.meta.url), "utf8")) as Expected).expect;
}

function agrees(found: unknown, wanted: unknown): boolean {
  if (typeof found === "number" && typeof wanted === "number") return Math.abs(found - wanted) <= 1e-9 * Math.max(Math.abs(wanted), 1);
  if (Array.isArray(found) && Array.isArray(wanted)) return found.length === wanted.length && found.every((one, at) => agrees(one, wanted[at]));
  return found === wanted;
}

/** The values of an output of the page's first figure. */
const items = (page: Page, name: string) =>
  page.locator("katydid-figure").first().evaluate((figure, of) => (figure as Figure).items(of), name);

for (const row of rows) {
  test(`the figure of ${row} gives the numbers of its row, and moves`, async ({ page }) => {
    await page.goto(`/learn/${row}/`);
    const figure = page.locator("katydid-figure").first();
    await expect(figure.locator(".stage img:visible")).toHaveCount(1);
    await figure.getByRole("button", { name: "Run the figure" }).click();
    await expect(figure).toHaveAttribute("data-state", "live");
    let compared = 0;
    for (const [name, wanted] of Object.entries(expected(row))) {
      // What a panel shows is compared where values are.
      if (wanted.some((one) => typeof one === "string")) continue;
      const found = await items(page, name);
      // A point that a panel shows is a text with its numbers.
      const read = found.map((one) => (typeof one === "string" && one.startsWith("{") ? one.slice(1, -1).split(",").map(Number) : one));
      expect(agrees(read, wanted), `${name}: ${JSON.stringify(found)}`).toBe(true);
      compared += 1;
    }
    expect(compared).toBeGreaterThan(1);
    const say = figure.locator(".say");
    const before = await say.textContent();
    const slider = figure.getByRole("slider").first();
    await slider.focus();
    for (let k = 0; k < 5; k++) await page.keyboard.press("ArrowRight");
    await expect(say).not.toHaveText(before ?? "");
    await expect(page).toHaveURL(/#.+=/);
  });
}

test("a number in the text, a step and an exercise, by keyboard alone", async ({ page }) => {
  await page.goto("/learn/C9/");
  const drag = page.locator(".drag").first();
  await drag.focus();
  await page.keyboard.press("Home");
  await expect(page.locator(".live").filter({ hasText: /^0$/ }).first()).toBeVisible();
  await expect(drag).toHaveAttribute("aria-valuenow", "0");
  const steps = page.locator(".steps");
  await steps.getByRole("button", { name: "Next step" }).press("Enter");
  await expect(steps.locator(".now")).toHaveCount(1);
  await expect(steps.locator(".now")).toContainText("(0, 0, 0)");
  const exercise = page.locator(".exercise").first();
  await exercise.getByRole("button", { name: "Check" }).press("Enter");
  await expect(exercise.locator(".verdict")).toContainText("Not yet");
  await drag.focus();
  for (let k = 0; k < 50; k++) await page.keyboard.press("PageUp");
  await page.keyboard.press("Home");
  for (let k = 0; k < 50; k++) await page.keyboard.press("PageUp");
  const told = Number(await drag.getAttribute("aria-valuenow"));
  expect(told).toBeCloseTo(0.5, 3);
  await exercise.getByRole("button", { name: "Check" }).press("Enter");
  await expect(exercise.locator(".verdict")).toContainText("That is right");
});

test("predictions tell, and the search finds", async ({ page }) => {
  await page.goto("/learn/V4/");
  const predict = page.locator(".predict").first();
  await predict.getByRole("radio").last().check();
  await expect(predict.locator(".verdict")).toContainText("That is right");
  await expect(predict.locator("details")).toHaveAttribute("open", "");
  await page.getByRole("searchbox").fill("casteljau");
  await page.locator(".found a").first().click();
  await expect(page).toHaveURL(/\/learn\/C9\//);
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`axe finds nothing, ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    for (const path of ["", "V4/", "C9/"]) {
      await page.goto(`/learn/${path}`);
      if (path !== "") {
        await page.locator("katydid-figure").first().evaluate((figure) => (figure as Figure).start());
        await expect(page.locator("katydid-figure").first()).toHaveAttribute("data-solved", /\d/);
      }
      await isAccessible(page);
    }
  });
}

test.describe("without JavaScript", () => {
  test.use({ javaScriptEnabled: false });
  test("pages read with stills, formulas, values and steps", async ({ page }) => {
    await page.goto("/learn/C9/");
    const still = page.locator(".stage img:visible");
    await expect(still).toHaveCount(1);
    await expect(page.locator("math").first()).toBeVisible();
    await expect(page.locator(".say")).toContainText("(0.91, 1.13, 0)");
    await expect(page.locator(".steps")).toContainText("(1/4, 1/2, 0)");
    await page.locator(".predict summary").first().click();
    await expect(page.locator(".predict details")).toHaveAttribute("open", "");
    await page.getByRole("link", { name: /Next|Previous/ }).first().click();
    await expect(page.locator("h1")).toBeVisible();
  });
});
