/** What a hand does without thinking, on every kind of control and with every button. */
import type { Locator, Page } from "@playwright/test";

import { centre, ground, grip, openCanvas, place, wire } from "./canvas";
import { openNew } from "./open";
import { expect, test } from "./test";

/** The part of each control that a hand works with, where a menu must come all the same. */
const CONTROLS: [string, string, string][] = [
  ["Number Slider", "5", ".track"],
  ["Number Slider", "5", ".number"],
  ["Button", "Button", ".pill"],
  ["Boolean Toggle", "Toggle", ".pill"],
  ["Value List", "Value List", "select"],
  ["MD Slider", "MD Slider", ".square"],
  ["Control Knob", "Control Knob", ".knob-face"],
  ["Digit Scroller", "Digit Scroller", ".digits"],
  ["Gene Pool", "Gene Pool", ".gene"],
  ["Colour Swatch", "Colour Swatch", ".swatch"],
];

for (const [name, words, part] of CONTROLS) {
  test(`a right click on ${part} of a ${name} opens its menu`, async ({ page }) => {
    await openCanvas(page);
    const object = await place(page, words, [300, 200]);
    await object.locator(part).first().click({ button: "right" });
    await expect(page.locator(".pop-menu").getByRole("menuitemcheckbox", { name: "Enabled" })).toBeVisible();
  });
}

test("a click on an entry that pointing has opened leaves its menu open", async ({ page }) => {
  await openCanvas(page);
  const circle = await place(page, "circ", [300, 200]);
  await circle.locator(".band").click({ button: "right" });
  const inputs = page.getByRole("menuitem", { name: "Inputs" });
  await inputs.hover();
  await expect(inputs).toHaveAttribute("aria-expanded", "true");
  await inputs.click();
  await expect(inputs).toHaveAttribute("aria-expanded", "true");
});

test("a middle click pastes nothing", async ({ page }) => {
  await openCanvas(page);
  const isPrevented = await ground(page).evaluate((element) => {
    const up = new MouseEvent("mouseup", { button: 1, bubbles: true, cancelable: true });
    element.dispatchEvent(up);
    return up.defaultPrevented;
  });
  expect(isPrevented).toBe(true);
});

test("Escape closes what a double-click on a swatch opened", async ({ page }) => {
  await openCanvas(page);
  const swatch = await place(page, "Colour Swatch", [300, 200]);
  await swatch.locator(".swatch").dblclick();
  await expect(page.locator(".sheet")).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(page.locator(".sheet")).toHaveCount(0);
});

test("circ and Enter give the component", async ({ page }) => {
  await openCanvas(page);
  const circle = await place(page, "circ", [300, 200]);
  await expect(circle).toHaveClass(/capsule/);
  await expect(circle.locator(".band")).toBeVisible();
});

test("full names are shown in full, and handles of near components stand beside them", async ({ page }) => {
  await openCanvas(page);
  const one = await place(page, "Divide Curve", [200, 160]);
  const merge = await place(page, "Merge", [200, 330]);
  await page.getByRole("menuitem", { name: "Canvas", exact: true }).click();
  await page.getByRole("menuitemcheckbox", { name: "Full names" }).click();
  for (const object of [one, merge]) {
    const clipped = await object.locator(".port").evaluateAll((all) => all.filter((port) => port.scrollWidth > port.clientWidth).map((port) => port.textContent));
    expect(clipped).toEqual([]);
  }
  await zoomIn(page, merge);
  const handles = merge.locator(".more");
  await expect(handles.first()).toBeVisible();
  expect(await overlaps(merge.locator(".port"), handles)).toBe(0);
});

test("the first edit moves nothing in the head of the page", async ({ page }) => {
  await openNew(page);
  const file = page.getByRole("menuitem", { name: "File" });
  const before = await file.boundingBox();
  await place(page, "5", [300, 200]);
  await expect(page.getByLabel("Changed since it was saved")).toBeVisible();
  expect(await file.boundingBox()).toEqual(before);
});

test("an input that is wired to nothing makes its object orange, and the line at the bottom counts it", async ({ page }) => {
  await openCanvas(page);
  const curve = await place(page, "Curve", [120, 160], "Params › Geometry");
  const move = await place(page, "Move", [330, 160], "Transform › Euclidean");
  await wire(page, grip(curve, "output"), grip(move, "input"));
  await expect(move).toHaveAttribute("data-look", "empty");
  await expect(page.locator(".status")).toContainText("⚠ 2");
  await page.locator(".status").getByRole("button", { name: /warnings/ }).click();
  await expect(page.getByRole("complementary")).toContainText("nothing comes to Geometry");
});

async function zoomIn(page: Page, at: Locator): Promise<void> {
  const { x, y } = await centre(at);
  await page.mouse.move(x, y);
  for (let k = 0; k < 8; k++) await page.mouse.wheel(0, -120);
}

/** How many of one kind of boxes lie over some of the other. */
async function overlaps(a: Locator, b: Locator): Promise<number> {
  const boxes = (all: Locator) => all.evaluateAll((list) => list.map((one) => one.getBoundingClientRect().toJSON() as DOMRect));
  const [first, second] = [await boxes(a), await boxes(b)];
  const meet = (p: DOMRect, q: DOMRect) => p.left < q.right - 1 && q.left < p.right - 1 && p.top < q.bottom - 1 && q.top < p.bottom - 1;
  return second.filter((one) => first.some((other) => meet(other, one))).length;
}
