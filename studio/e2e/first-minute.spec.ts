/**
 * The first minute of ten definitions that are opened cold: after two seconds the geometry is in the picture, or the viewport
 * says why there is none. The pictures lie among the results of the tests, for people to look at.
 */
import type { Page } from "@playwright/test";

import { openNew, openText } from "./open";
import { expect, test } from "./test";

const kd = (...lines: string[]) => ["katydid 1", ...lines, ""].join("\n");

/** A thousand objects and more: rows of sliders that are added up, each row a tower. */
function large(): string {
  const lines: string[] = [];
  for (let k = 0; k < 300; k++) {
    lines.push(`height${k} = Number Slider(${2 + (k % 7)}.0, 0..10)`);
    lines.push(`place${k} = Construct Point(${(k % 20) * 4}, ${Math.floor(k / 20) * 4}, 0)`);
    lines.push(`wide${k} = Multiplication(height${k}, 0.2)`);
    lines.push(`tower${k} = Circle(place${k}, wide${k})`);
  }
  return kd(...lines);
}

/** What is opened, and what the viewport says where nothing is to be seen. */
const DEFINITIONS: [name: string, text: string, says?: RegExp][] = [
  ["small", kd("r = Number Slider(6.0, 1..20)", "c = Circle(_, r)", "d = Divide Curve(c, 12)")],
  ["large", large()],
  ["one-point", kd("p = Construct Point(0, 0, 0)")],
  ["far-from-the-origin", kd("p = Construct Point(4000000, -3000000, 100)", "c = Circle(p, 25)", "e = Extrude(c, (0, 0, 60))")],
  ["millimetres", kd("units millimetres", "c = Circle(_, 0.02)")],
  ["kilometres", kd("units kilometers", "c = Circle(_, 40000)", "d = Divide Curve(c, 30)")],
  ["needs-a-model", kd("q = Geometry Pipeline(types = [curve])", "d = Divide Curve(q, 8)"), /needs 1 .* of a Rhino model/],
  ["previews-off", kd("c = Circle(_, 4) hidden", "d = Divide Curve(c, 9) hidden"), /preview of 2 objects is off/],
  ["null", kd("r = Curve()", "d = Divide Curve(r, 9)"), /no geometry to show/],
  ["numbers", kd("a = Number Slider(2.0, 0..9)", "s = Addition(a, 3)", "p = Panel(s)"), /makes no geometry/],
];

for (const [name, text, says] of DEFINITIONS) {
  test(`${name} tells in two seconds`, async ({ page }, info) => {
    await openText(page, `${name}.kd`, text);
    await page.waitForTimeout(2000);
    await page.screenshot({ path: info.outputPath(`${name}.png`) });
    if (says) await expect(page.locator(".viewport-telling")).toHaveText(says);
    else await expect(page.locator(".viewport-telling")).toHaveCount(0);
    const seen = await share(page);
    if (says) return;
    expect(seen?.reach, "nothing is cut off").toBeLessThanOrEqual(1.001);
    if (name !== "one-point") expect(seen?.reach, "and nothing is a speck").toBeGreaterThan(0.5);
  });
}

test("what the viewport says stands above the picture, and the camera frames what is below", async ({ page }, info) => {
  await openText(page, "partly.kd", kd("q = Geometry Pipeline(types = [curve])", "d = Divide Curve(q, 8)", "c = Circle(_, 10)", "e = Extrude(c, (0, 0, 40))"));
  const said = page.locator(".viewport-telling");
  await expect(said).toHaveText(/needs 1 .* of a Rhino model/);
  await expect.poll(async () => (await share(page))?.reach).toBeGreaterThan(0.5);
  expect((await share(page))?.reach).toBeLessThanOrEqual(1.001);
  await page.screenshot({ path: info.outputPath("partly.png") });
  const [row, host] = [await said.boundingBox(), await page.locator(".viewport-host").boundingBox()];
  expect(row?.y).toBeLessThan(host?.y ?? 0);
  expect((row?.y ?? 0) + (row?.height ?? 0)).toBeLessThanOrEqual((host?.y ?? 0) + 0.5);
});

test("geometry that comes later is in the picture, until a hand takes the camera", async ({ page }) => {
  await openText(page, "grows.kd", kd("r = Number Slider(5.0, 1..900)", "c = Circle(_, r)"));
  await expect.poll(async () => (await share(page))?.reach).toBeGreaterThan(0.5);
  const slider = page.getByRole("slider");
  await slider.focus();
  await page.keyboard.press("End");
  await expect(slider).toHaveAttribute("aria-valuenow", "900");
  await expect.poll(async () => (await share(page))?.reach).toBeLessThanOrEqual(1.001);
  // The hand turns the view; from then on it stays.
  const stage = await page.locator(".viewport-canvas").boundingBox();
  await page.mouse.move((stage?.x ?? 0) + 200, (stage?.y ?? 0) + 300);
  await page.mouse.wheel(0, 100);
  await slider.focus();
  await page.keyboard.press("Home");
  await expect(slider).toHaveAttribute("aria-valuenow", "1");
  await expect.poll(async () => (await share(page))?.reach).toBeLessThan(0.3);
});

test("an empty canvas says how one begins, and a start page closes what is open", async ({ page }) => {
  await openNew(page);
  await expect(page.locator(".hints")).toContainText("Double-click");
  await page.getByRole("button", { name: "Start page" }).click();
  // Those with edits that are not saved ask first: this one has none.
  const shut = page.getByRole("button", { name: /^Close Unnamed definition/ });
  const tiles = page.getByRole("listitem").filter({ has: shut, hasNotText: "•" });
  await expect(tiles.first()).toBeVisible();
  const before = await tiles.count();
  // The page that was left lets go of it a moment later.
  await expect(async () => {
    await tiles.first().locator(shut).click();
    await expect.poll(() => tiles.count(), { timeout: 2000 }).toBeLessThan(before);
  }).toPass();
});

/** How far from the middle of the viewport the model reaches, 1 being its edge; nothing where there is no model. */
async function share(page: Page): Promise<{ reach: number } | undefined> {
  return await page.evaluate(() => {
    const viewport = window.__studio?.viewport;
    const bounds = viewport?.stats()?.bounds;
    const host = document.querySelector(".viewport-host")?.getBoundingClientRect();
    if (!viewport || !bounds || !host) return undefined;
    let reach = 0;
    for (let k = 0; k < 8; k++) {
      const corner = [0, 1, 2].map((axis) => bounds[(k >> axis) & 1 ? 1 : 0][axis] ?? 0) as [number, number, number];
      const at = viewport.place(corner);
      if (!at) return { reach: Infinity };
      reach = Math.max(reach, Math.abs(at[0] / host.width - 0.5) * 2, Math.abs(at[1] / host.height - 0.5) * 2);
    }
    return { reach };
  });
}
