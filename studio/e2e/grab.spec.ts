/** A particle of a solver is dragged in the viewport with Alt: the form follows, and nothing of it is kept. */
import type { Page } from "@playwright/test";

import { openText } from "./open";
import { expect, test } from "./test";

// Objects stand close together, so that the canvas shows their texts.
const ROPE = `katydid 1
rope = Line((0, 0, 0), (8, 0, 0)) hidden
points = Divide Curve(rope, 8) -> Points |hidden
chain = PolyLine(points) hidden
links = Explode(chain) hidden
springs = \`Length(Line)\`(links.Segments, 1.1, 20)
weight = Load(points, (0, 0, -1))
held = Anchor([(0, 0, 0), (8, 0, 0)]) hidden
grab = Grab()
solved = Solver([springs, weight, held, grab.Goal])
middle = List Item(solved.Vertices, 5) hidden
place = Deconstruct(middle)
height = Panel(place.Z)

layout {
rope: 0 0
points: 170 0
chain: 340 0
links: 510 0
springs: 0 130
weight: 170 130
held: 340 130
grab: 510 130
solved: 0 260
middle: 170 260
place: 340 260
height: 510 260
}
`;

async function height(page: Page): Promise<number> {
  const text = await page.getByRole("group", { name: /^height/ }).innerText();
  return Number(/-?\d+\.\d+/.exec(text)?.[0]);
}

/** Where a point of the model is on the page. */
async function onPage(page: Page, point: [number, number, number]): Promise<{ x: number; y: number }> {
  const box = await page.locator(".viewport-canvas").boundingBox();
  const at = await page.evaluate((point) => window.__studio?.viewport?.place(point), point);
  if (!box || !at) throw new Error("there is no such place");
  return { x: box.x + at[0], y: box.y + at[1] };
}

/** Takes the middle of the rope with Alt and drags it up, and holds it there. */
async function hold(page: Page, rest: number, up: number): Promise<void> {
  const [from, to] = [await onPage(page, [4, 0, rest]), await onPage(page, [4, 0, rest + up])];
  await page.mouse.move(from.x, from.y);
  await page.keyboard.down("Alt");
  await page.mouse.down();
  await page.mouse.move(from.x, from.y - 8);
  await page.mouse.move(to.x, to.y, { steps: 6 });
}

test("a particle follows the pointer while it is held, and goes back", async ({ page }, info) => {
  await openText(page, "rope.kd", ROPE);
  await expect.poll(() => height(page)).toBeLessThan(-0.5);
  const rest = await height(page);
  await hold(page, rest, 1.5);
  await expect.poll(async () => (await height(page)) - rest).toBeGreaterThan(1);
  await expect(page.locator(".viewport-grab")).toBeVisible();
  await expect(page.getByRole("status").filter({ hasText: "press Escape" })).toBeVisible();
  await page.screenshot({ path: info.outputPath("held.png") });
  await page.mouse.up();
  await page.keyboard.up("Alt");
  await expect.poll(async () => Math.abs((await height(page)) - rest)).toBeLessThan(1e-3);
  await expect(page.locator(".viewport-grab")).toBeHidden();
  // Nothing is kept, so there is nothing to take back.
  await page.keyboard.press("Control+Z");
  await expect(page.getByRole("group", { name: /^height/ })).toBeVisible();
  expect(Math.abs((await height(page)) - rest)).toBeLessThan(1e-3);
});

test("Escape lets go, and without Alt a window is drawn", async ({ page }) => {
  await openText(page, "rope.kd", ROPE);
  await expect.poll(() => height(page)).toBeLessThan(-0.5);
  const rest = await height(page);
  await hold(page, rest, 1.5);
  await expect.poll(async () => (await height(page)) - rest).toBeGreaterThan(1);
  await page.keyboard.up("Alt");
  await page.keyboard.press("Escape");
  await expect.poll(async () => Math.abs((await height(page)) - rest)).toBeLessThan(1e-3);
  await page.mouse.up();
  const from = await onPage(page, [4, 0, rest]);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x, from.y - 60, { steps: 4 });
  await expect(page.locator(".viewport-window")).toBeVisible();
  await page.mouse.up();
  expect(Math.abs((await height(page)) - rest)).toBeLessThan(1e-3);
});
