/** The site's front page: it reads without a script, in small windows and in the dark, and leads to what is there. */
import { AxeBuilder } from "@axe-core/playwright";
import { expect, test, type Page } from "@playwright/test";

/** Goes through the page, so that pictures that wait to be seen are fetched. */
async function seeAll(page: Page): Promise<void> {
  for (const picture of await page.locator("main img:visible").all()) {
    await picture.scrollIntoViewIfNeeded();
    await expect.poll(() => picture.evaluate((image: HTMLImageElement) => image.complete && image.naturalWidth)).toBeGreaterThan(0);
  }
}

for (const colorScheme of ["light", "dark"] as const) {
  for (const width of [1280, 390]) {
    test(`${colorScheme}, ${width} wide: accessible, nothing beyond the window, all pictures there`, async ({ page }, info) => {
      const faults: string[] = [];
      page.on("pageerror", (error) => faults.push(String(error)));
      page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
      page.on("response", (response) => response.status() >= 400 && faults.push(`${response.status()} ${response.url()}`));
      await page.setViewportSize({ width, height: 844 });
      await page.emulateMedia({ colorScheme });
      await page.goto("/index.html");
      await seeAll(page);
      expect(await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth)).toBeLessThanOrEqual(0);
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      await page.screenshot({ path: info.outputPath("front.png"), fullPage: true });
      expect(faults).toEqual([]);
    });
  }
}

test("without a script the figure stands still and the tables are whole", async ({ browser, baseURL }) => {
  const context = await browser.newContext({ javaScriptEnabled: false, baseURL: baseURL ?? "" });
  const page = await context.newPage();
  await page.goto("/index.html");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Grasshopper definitions without Rhino");
  await expect(page.locator("katydid-figure .stage img.light")).toBeVisible();
  await expect(page.locator("katydid-figure .say")).toContainText("faces; it holds");
  expect(await page.getByRole("table").first().getByRole("row").count()).toBeGreaterThan(6);
  expect(await page.locator("td.slower").count()).toBeGreaterThan(0);
  await context.close();
});

test("its links lead to pages that are there", async ({ page, request }) => {
  await page.goto("/index.html");
  const links = await page.locator("a[href]").evaluateAll((all) => all.map((one) => (one as HTMLAnchorElement).href));
  expect(links.length).toBeGreaterThan(8);
  for (const link of new Set(links.map((one) => one.split("#")[0] ?? ""))) {
    // The studio's page is built with the engine, by `make site`.
    if (link.endsWith("/studio.html")) continue;
    expect((await request.get(link)).status(), link).toBe(200);
  }
});
