/** The studio as a folder of files: the engine is in the page, what is edited is kept in the browser. */
import { expect, test as plain, type Page } from "@playwright/test";

import type {} from "../../src/viewport/current";

/** A page that writes an error to the console, or asks anything of another address, fails its test. */
const test = plain.extend<{ watched: undefined; excused: RegExp[] }>({
  excused: [[], { option: true }],
  watched: [
    async ({ context, baseURL, excused }, use) => {
      const faults: string[] = [];
      const own = new URL(baseURL ?? "").host;
      context.on("console", (message) => {
        if (message.type() === "error") faults.push(`${message.text()} (${message.location().url})`);
      });
      context.on("weberror", (error) => faults.push(String(error.error())));
      context.on("request", (request) => {
        const { protocol, host } = new URL(request.url());
        if (!["data:", "blob:"].includes(protocol) && host !== own) faults.push(`asked ${request.url()}`);
      });
      await use(undefined);
      expect(faults.filter((fault) => !excused.some((excuse) => excuse.test(fault))).slice(0, 9)).toEqual([]);
    },
    { auto: true },
  ],
});

const TEXT = "katydid 1\nr = Number Slider(6.0, 1..20)\nc = Circle(_, r)\nd = Divide Curve(c, 12)\n";

async function openText(page: Page, text = TEXT): Promise<void> {
  await page.goto("/studio.html");
  await page.locator("input[type=file]").setInputFiles({ name: "circle.kd", mimeType: "text/plain", buffer: Buffer.from(text) });
  await onWorkbench(page);
}

async function onWorkbench(page: Page): Promise<void> {
  await page.waitForURL(/document=/);
  await expect(page.getByRole("status").filter({ hasText: /Solved/ })).toBeVisible();
}

/** How far the model reaches along x. */
async function width(page: Page): Promise<number | undefined> {
  return await page.evaluate(() => {
    const bounds = window.__studio?.viewport?.stats()?.bounds;
    return bounds ? Math.round((bounds[1][0] ?? 0) - (bounds[0][0] ?? 0)) : undefined;
  });
}

test("a definition is opened, its slider moved, and the edit is there after the page is loaded anew", async ({ page }, info) => {
  await openText(page);
  await expect.poll(() => width(page)).toBe(12);
  const slider = page.getByRole("slider");
  await slider.focus();
  await page.keyboard.press("End");
  await expect(slider).toHaveAttribute("aria-valuenow", "20");
  await expect.poll(() => width(page)).toBe(40);
  await page.screenshot({ path: info.outputPath("moved.png") });
  await page.waitForTimeout(500);
  await page.reload();
  await onWorkbench(page);
  await expect(page.getByRole("slider")).toHaveAttribute("aria-valuenow", "20");
  await expect.poll(() => width(page)).toBe(40);
  // Its history is there too.
  await page.keyboard.press("Control+z");
  await expect(page.getByRole("slider")).toHaveAttribute("aria-valuenow", "6");
  await expect.poll(() => width(page)).toBe(12);
});

test("what another window left is offered again", async ({ context, page }) => {
  await openText(page);
  await page.getByRole("slider").focus();
  await page.keyboard.press("Home");
  await expect(page.getByRole("slider")).toHaveAttribute("aria-valuenow", "1");
  await page.waitForTimeout(500);
  const address = page.url();
  await page.close();
  const other = await context.newPage();
  await other.goto(address);
  await onWorkbench(other);
  await expect(other.getByRole("slider")).toHaveAttribute("aria-valuenow", "1");
  await expect(other.getByRole("alert").filter({ hasText: /edit|step/i }).first()).toBeVisible();
});

test("a definition of the gallery opens, and the player shows it", async ({ page }, info) => {
  await page.goto("/studio.html");
  const tile = page.getByRole("main").getByRole("button", { name: /Twisted tower/ }).first();
  await expect(tile).toBeVisible();
  await page.screenshot({ path: info.outputPath("start.png") });
  await tile.click();
  await onWorkbench(page);
  await expect.poll(() => width(page)).toBeGreaterThan(0);
  await page.goto(`${page.url()}&player`);
  await expect(page.getByRole("complementary", { name: "Inputs" }).getByRole("slider").first()).toBeVisible();
  await expect.poll(() => width(page)).toBeGreaterThan(0);
  await page.screenshot({ path: info.outputPath("player.png") });
});

test("a link has all of the definition in it", async ({ page }) => {
  await openText(page);
  await page.getByRole("slider").focus();
  await page.keyboard.press("End");
  await expect(page.getByRole("slider")).toHaveAttribute("aria-valuenow", "20");
  await page.keyboard.press("Control+k");
  await page.keyboard.type("copy a link");
  await page.keyboard.press("Enter");
  await expect(page.getByText("The link is copied")).toBeVisible();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link).toContain("#");
  const before = page.url();
  await page.goto("about:blank");
  await page.goto(link);
  await onWorkbench(page);
  expect(page.url()).not.toBe(before);
  await expect(page.getByRole("slider")).toHaveAttribute("aria-valuenow", "20");
  await expect.poll(() => width(page)).toBe(40);
});

test("files come out: the definition and what it makes", async ({ page }) => {
  await openText(page);
  // This browser's picker cannot be pressed by a test: without it the browser keeps the file.
  await page.evaluate(() => Reflect.deleteProperty(globalThis, "showSaveFilePicker"));
  await page.keyboard.press("Control+Shift+s");
  const saved = page.waitForEvent("download");
  await page.getByRole("dialog").getByRole("button", { name: /\.kd/ }).click();
  expect((await saved).suggestedFilename()).toBe("circle.kd");
  await page.keyboard.press("Control+Shift+e");
  for (const format of ["3dm", "svg"]) {
    const exported = page.waitForEvent("download");
    await page.getByRole("dialog").getByRole("button", { name: `.${format}`, exact: true }).click();
    expect((await exported).suggestedFilename()).toBe(`circle.${format}`);
  }
});

test("help and search know the components", async ({ page }) => {
  await openText(page);
  await page.keyboard.press("Control+k");
  await page.keyboard.type("help on a component");
  // The first empties the field, the second closes the search.
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await page.locator(".react-flow__pane").dblclick({ position: { x: 60, y: 300 } });
  await page.keyboard.type("addition");
  await expect(page.getByRole("option", { name: /Addition/ }).first()).toBeVisible();
});

test("what moves a result is told, and a wanted one is found, with no server", async ({ page }, info) => {
  const text =
    'katydid 1\nr = Number Slider(2.0000, 0.5000..10.0000)\nh = Number Slider(3.0000, 1.0000..9.0000)\n' +
    'volume = Expression("3*r^2*h", r = r, h = h)\nc = Circle(_, r)\nlayout {\n  r: 40 40\n  h: 40 80\n  volume: 320 60\n  c: 320 200\n}\n';
  await openText(page, text);
  await page.getByRole("group", { name: /^volume\b/ }).locator(".band, .name, .title").first().click();
  await page.keyboard.press("Control+Shift+Y");
  const panel = page.getByRole("complementary", { name: "Effects" });
  await panel.getByRole("button", { name: "What moves it here" }).click();
  const row = (name: string) => panel.getByRole("row").filter({ hasText: name });
  // 6 r h and 3 r².
  await expect(row("r").filter({ hasText: "36 ±" })).toBeVisible();
  await expect(row("h").filter({ hasText: "12 ±" })).toBeVisible();
  await panel.getByRole("button", { name: "What moves it over the whole ranges" }).click();
  await expect(panel.getByText(/points solved, 0 without a number/)).toBeVisible();
  await panel.getByRole("button", { name: "Show in the view how places move with r" }).click();
  await expect(panel.getByRole("button", { name: "Show in the view how places move with r" })).toHaveAttribute("aria-pressed", "true");
  await page.screenshot({ path: info.outputPath("effects.png") });
  await panel.getByRole("checkbox", { name: "h", exact: true }).uncheck();
  await panel.getByLabel("Number, or x, y, z").fill("225");
  await panel.getByRole("button", { name: "Find" }).click();
  // 9 r² = 225: r is 5, and h stays.
  await expect.poll(() => width(page)).toBe(10);
});

test("it works without a network once it was seen", async ({ context, page }) => {
  await page.goto("/studio.html");
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
  });
  await expect.poll(() => page.evaluate(() => caches.keys().then((names) => names.length))).toBeGreaterThan(0);
  await page.waitForTimeout(500);
  await page.reload();
  await context.setOffline(true);
  await page.reload();
  await openText(page);
  await expect.poll(() => width(page)).toBe(12);
  await context.setOffline(false);
});
