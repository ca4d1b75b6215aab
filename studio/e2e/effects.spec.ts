/** The Effects panel on the real session: what moves a result, a wanted result, a computed point that is dragged. */
import type { Page } from "@playwright/test";

import { isAccessible } from "./access";
import { centre, drag } from "./canvas";
import { openText } from "./open";
import { expect, test } from "./test";

const TOWER = `katydid 1
r = Number Slider(2.0000, 0.5000..10.0000)
h = Number Slider(3.0000, 1.0000..9.0000)
n = Number Slider(4, 1..8)
volume = Expression("3*r^2*h + n", r = r, h = h, n = n)
shown = Panel(volume)
p = Construct Point(r, h, 0)
radius = Panel(r)

layout {
    r: 40 40
    h: 40 80
    n: 40 120
    volume: 320 60
    shown: 460 40 [460 40 120 40]
    p: 320 160
    radius: 460 160 [460 160 120 40]
}
`;

const node = (page: Page, name: string) => page.getByRole("group", { name: new RegExp(`^${name}\\b`) });
const take = (page: Page, name: string) => node(page, name).locator(".band, .name, .title").first().click();

test("what moves a result is told, and a wanted one is found and taken back", async ({ page }, info) => {
  await openText(page, "tower.kd", TOWER);
  await take(page, "volume");
  await page.keyboard.press("Control+Shift+Y");
  const panel = page.getByRole("complementary", { name: "Effects" });
  await panel.getByRole("button", { name: "What moves it here" }).click();
  const row = (name: string) => panel.getByRole("row").filter({ hasText: name });
  // 6 r h, 3 r², and a step of a whole number.
  await expect(row("r").filter({ hasText: "36 ±" })).toBeVisible();
  await expect(row("h").filter({ hasText: "12 ±" })).toBeVisible();
  await expect(row("n").filter({ hasText: "-1 for a step down, 1 for a step up" })).toBeVisible();
  await panel.getByRole("button", { name: "Show in the view how places move with r" }).click();
  await expect(panel.getByRole("button", { name: "Show in the view how places move with r" })).toHaveAttribute("aria-pressed", "true");
  await panel.getByRole("button", { name: "What moves it over the whole ranges" }).click();
  await expect(panel.getByText(/points solved, 0 without a number/)).toBeVisible();
  await isAccessible(page);
  await page.screenshot({ path: info.outputPath("effects.png") });
  await panel.getByRole("checkbox", { name: "h", exact: true }).uncheck();
  await panel.getByLabel("Number, or x, y, z").fill("229");
  await panel.getByRole("button", { name: "Find" }).click();
  // 9 r² = 225: r is 5, and h stays.
  await expect(node(page, "shown")).toContainText("229");
  await expect(node(page, "radius")).toContainText("5");
  await page.locator("#canvas").focus();
  await page.keyboard.press("Control+Z");
  await expect(node(page, "shown")).toContainText("40");
});

test("sliders follow a computed point that is dragged", async ({ page }) => {
  await openText(page, "tower.kd", TOWER);
  await take(page, "p");
  await page.keyboard.press("Control+Shift+Y");
  await page.getByRole("complementary", { name: "Effects" }).getByRole("checkbox", { name: "Drag its points in the view" }).check();
  const handle = page.getByRole("button", { name: /^Point 0 of p/ });
  await expect(handle).toBeVisible();
  await handle.focus();
  await page.keyboard.press("ArrowRight");
  await expect(node(page, "radius")).not.toContainText(/^radius\s*2$/);
  const from = await centre(handle);
  await drag(page, from, { x: from.x + 40, y: from.y });
  await expect(handle).not.toHaveAccessibleName(/2, 3, 0/);
});
