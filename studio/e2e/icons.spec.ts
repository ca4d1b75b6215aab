import { ground, openCanvas, place, spot } from "./canvas";
import { expect, test } from "./test";

test.beforeEach(async ({ page }) => {
  await openCanvas(page);
});

test("capsules show icons for names, here and after a reload", async ({ page }) => {
  const circle = await place(page, "divide curve", [250, 180]);
  await expect(circle.locator(".band")).toHaveText(/Divide/);
  await ground(page).click({ button: "right", position: { x: 500, y: 300 } });
  await page.getByRole("menuitemcheckbox", { name: "Draw icons" }).click();
  const icon = circle.locator(".band .icon");
  await expect(icon).toHaveAttribute("data-icon", "Divide Curve");
  await expect(circle.locator(".band")).toHaveText("");
  expect(await icon.evaluate((one) => one.getBoundingClientRect().width)).toBeGreaterThanOrEqual(16);
  await page.reload();
  await expect(page.locator(".band .icon")).toHaveCount(1);
});

for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]] as const) {
  test(`all of a panel lies on the page at ${width} pixels, and the wheel moves tabs that are out of sight`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    const names = page.locator(".ribbon .more-of");
    for (let k = 0; k < (await names.count()); k++) {
      await names.nth(k).click();
      const sheet = await page.locator(".ribbon .all").boundingBox();
      expect(sheet?.x).toBeGreaterThanOrEqual(0);
      expect((sheet?.x ?? 0) + (sheet?.width ?? 0)).toBeLessThanOrEqual(width);
      expect((sheet?.y ?? 0) + (sheet?.height ?? 0)).toBeLessThanOrEqual(height);
      await page.locator(".ribbon .all .entry").last().scrollIntoViewIfNeeded();
      await expect(page.locator(".ribbon .all .entry").last()).toBeInViewport();
      await names.nth(k).click();
    }
    const tabs = page.getByRole("tablist");
    const isLonger = await tabs.evaluate((row) => row.scrollWidth > row.clientWidth + 1);
    expect(await tabs.evaluate((row) => row.classList.contains("goes-on"))).toBe(isLonger);
    if (!isLonger) return;
    await tabs.hover();
    await page.mouse.wheel(0, 2000);
    await expect(tabs.getByRole("tab").last()).toBeInViewport({ ratio: 1 });
  });
}

test("on a phone the panels come with a press on their tab, and go when a component was chosen", async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await page.reload();
  const tab = page.getByRole("tab", { name: "Curve", exact: true });
  await expect(tab).toBeVisible();
  await expect(page.getByRole("tabpanel")).toHaveCount(0);
  await tab.click();
  await page.getByRole("tabpanel", { name: "Curve" }).getByRole("button", { name: /^Primitive/ }).click();
  await page.locator(".ribbon .all").getByRole("button", { name: "Circle", exact: true }).click();
  await expect(page.getByRole("tabpanel")).toHaveCount(0);
  const { x, y } = await spot(page, [120, 100]);
  await page.mouse.click(x, y);
  await expect(page.locator("[data-object]")).toHaveCount(1);
});

test("the tabs and the finds show icons", async ({ page }) => {
  await expect(page.getByRole("tabpanel").locator(".entry .icon").first()).toBeVisible();
  await page.getByRole("tab", { name: "Curve" }).click();
  const { x, y } = await spot(page, [400, 300]);
  await page.mouse.dblclick(x, y);
  await page.keyboard.type("voronoi");
  const first = page.getByRole("option").first();
  await expect(first.locator('[data-icon="Voronoi"] path')).not.toHaveCount(0);
});
