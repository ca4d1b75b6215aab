/** The gumball on the real session: what a parameter keeps moves, turns and scales, and is saved so. */
import type { Page } from "@playwright/test";

import { centre, drag } from "./canvas";
import { isAccessible } from "./access";
import { openText } from "./open";
import { expect, test } from "./test";

async function setLine(page: Page): Promise<void> {
  await openText(page, "line.kd", `katydid 1\nshape = Curve()\nends = End Points(shape)\nlist = Panel(ends.E)\n\nlayout {\n    shape: 40 40\n    ends: 160 40\n    list: 300 40 [300 40 200 60]\n}\n`);
  const shape = page.getByRole("group", { name: /^shape/ });
  await shape.locator(".band, .name, .title").first().click({ button: "right" });
  await page.getByRole("menuitem", { name: /^Set one curve/ }).click();
  await page.getByRole("radio", { name: "Line", exact: true }).click();
  for (const typed of ["0,0", "4,2"]) {
    await page.keyboard.type(typed);
    await page.keyboard.press("Enter");
  }
  await expect(page.getByRole("group", { name: /^list/ })).toContainText("{4, 2, 0}");
  await shape.locator(".band, .name, .title").first().click();
}

test("a curve that a parameter keeps is moved, turned and scaled; each is one step for Undo", async ({ page }, info) => {
  await setLine(page);
  const list = page.getByRole("group", { name: /^list/ });
  const gumball = page.getByRole("group", { name: "Gumball" });
  await expect(gumball).toBeVisible();
  await isAccessible(page);
  const amount = async (grip: string, text: string) => {
    await gumball.getByRole("button", { name: grip, exact: true }).click();
    await page.keyboard.type(text);
    await page.keyboard.press("Enter");
  };
  await amount("Move along z", "10/2");
  await expect(list).toContainText("{4, 2, 5}");
  // About the middle, (2, 1).
  await amount("Scale along x", "3");
  await expect(list).toContainText("{8, 2, 5}");
  await amount("Rotate about z", "90");
  await expect(list).toContainText("{1, 7, 5}");
  await page.screenshot({ path: info.outputPath("gumball.png") });
  for (const before of ["{8, 2, 5}", "{4, 2, 5}", "{4, 2, 0}"]) {
    await page.keyboard.press("Control+Z");
    await expect(list).toContainText(before);
  }
  const from = await centre(gumball.getByRole("button", { name: "Move along z", exact: true }));
  await drag(page, from, { x: from.x, y: from.y - 60 });
  await expect(list).not.toContainText("{4, 2, 0}");
  await expect(list).toContainText(/\{4, 2, \d/);
  await page.keyboard.press("Control+Z");
  await expect(list).toContainText("{4, 2, 0}");
});

test("a plane and a vector are drawn", async ({ page }) => {
  await openText(page, "frames.kd", `katydid 1\np = Plane()\nv = Vector()\nshown = Panel(p)\nlength = Panel(v)\n\nlayout {\n    p: 40 40\n    v: 40 140\n    shown: 200 40 [200 40 260 60]\n    length: 200 140 [200 140 260 60]\n}\n`);
  for (const [name, kind, first, second, panel, text] of [
    ["p", "plane", "1,2", "1,5", "shown", /O\(1.00,2.00,0.00\) Z\(-?0.00,-?0.00,1.00\)/],
    ["v", "vector", "1,1", "4,5", "length", "{3, 4, 0}"],
  ] as const) {
    await page.getByRole("group", { name: new RegExp(`^${name}\\b`) }).locator(".band, .name, .title").first().click({ button: "right" });
    await page.getByRole("menuitem", { name: new RegExp(`^Set one ${kind}`) }).click();
    for (const typed of [first, second]) {
      await page.keyboard.type(typed);
      await page.keyboard.press("Enter");
    }
    await expect(page.getByRole("group", { name: new RegExp(`^${panel}`) })).toContainText(text);
  }
});
