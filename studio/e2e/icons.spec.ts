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

test("the tabs and the finds show icons", async ({ page }) => {
  await expect(page.getByRole("tabpanel").locator(".entry .icon").first()).toBeVisible();
  await page.getByRole("tab", { name: "Curve" }).click();
  const { x, y } = await spot(page, [400, 300]);
  await page.mouse.dblclick(x, y);
  await page.keyboard.type("voronoi");
  const first = page.getByRole("option").first();
  await expect(first.locator('[data-icon="Voronoi"] path')).not.toHaveCount(0);
});
