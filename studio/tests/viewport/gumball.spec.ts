import { expect, test, type Page } from "@playwright/test";

import type { Edit } from "../../src/core/protocol/Edit";
import type { Request } from "../../src/core/protocol/Request";
import type {} from "../../src/viewport/current";

const PORT = "0f8fad5b-d9cb-469f-a165-70867728950e";
type Transform = Extract<Edit, { do: "transform" }>;

/** A parameter that keeps a line from the origin to (6, 4, 2), and what is asked of the session. */
async function open(page: Page, isPoint = false): Promise<Request[]> {
  const asked: Request[] = [];
  await page.routeWebSocket(/\/socket/, (socket) => {
    socket.onMessage((data) => {
      const request = JSON.parse(String(data)) as Request;
      asked.push(request);
      socket.send(JSON.stringify({ event: "done", seq: request.seq, revision: 1, made: [] }));
    });
  });
  await page.goto("/tests/viewport/page.html?bare");
  await page.evaluate(([id, isPoint]) => {
    const { join, documentStore, feed, select } = window.test;
    join("d", "t");
    const port = { id, sources: [], kept: 1, kind: isPoint ? "Point" : "Curve" };
    const object = { id, component: isPoint ? "fbac3e32-f100-4292-8692-77240a42fd1a" : "x", kind: "parameter", nickname: "Crv", inputs: [port], outputs: [port] };
    documentStore.setState({ objects: new Map([[id, object as never]]) });
    const part = isPoint ? { kind: "points" as const, positions: [6, 4, 2] } : { kind: "curves" as const, positions: [0, 0, 0, 6, 4, 2] };
    feed({ object: id, bounds: null, parts: [part] }, { object: "other", bounds: null, parts: [{ kind: "curves", positions: [-20, -20, 0, 20, 20, 0] }] });
    return new Promise<void>((resolve) => setTimeout(() => (select([id]), resolve()), 300));
  }, [PORT, isPoint] as const);
  await expect(page.getByRole("group", { name: "Gumball" })).toBeVisible();
  return asked;
}

const made = (asked: Request[]) =>
  asked.flatMap(({ ask }) => (ask.ask === "edit" && ask.edit.do === "transform" ? [{ ...(ask.edit as Transform), gesture: ask.gesture }] : []));
const place = (page: Page, point: [number, number, number]) => page.evaluate((at) => window.__studio!.viewport!.place(at)!, point);

/** Drags a grip by as many pixels as a step in the model is. */
async function drag(page: Page, name: string, by: [number, number, number], keys: string[] = []): Promise<void> {
  const box = (await page.getByRole("button", { name, exact: true }).boundingBox())!;
  const [from, to] = [await place(page, [3, 2, 1]), await place(page, [3 + by[0], 2 + by[1], 1 + by[2]])];
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (const key of keys) await page.keyboard.down(key);
  await page.mouse.move(x + (to[0] - from[0]) / 2, y + (to[1] - from[1]) / 2, { steps: 3 });
  await page.mouse.move(x + to[0] - from[0], y + to[1] - from[1], { steps: 3 });
}

test("a grip moves along its axis, on the grid, as one step for Undo", async ({ page }) => {
  const asked = await open(page);
  await drag(page, "Move along x", [5, 0, 0]);
  await page.mouse.up();
  await expect.poll(() => asked.filter(({ ask }) => ask.ask === "draft").length).toBe(2);
  const edits = made(asked);
  const { map, ports } = edits.at(-1)!;
  expect(ports).toEqual([PORT]);
  expect(map.map((row) => row.slice(0, 3))).toEqual([[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
  expect(map[0][3]).toBeGreaterThan(3.5);
  expect(map[0][3]).toBeLessThan(6.5);
  expect([map[1][3], map[2][3]]).toEqual([0, 0]);
  expect(new Set(edits.map(({ gesture }) => gesture)).size).toBe(1);
});

test("a grip scales about the middle, with Shift along all axes", async ({ page }) => {
  const asked = await open(page);
  await drag(page, "Scale along x", [-4, 0, 0]);
  await page.mouse.up();
  await expect.poll(() => asked.filter(({ ask }) => ask.ask === "draft").length).toBe(2);
  const [x, y, z] = made(asked).at(-1)!.map;
  expect(x[0]).toBeGreaterThan(1.1);
  // The middle, 3, stays.
  expect(x[3]).toBeCloseTo(3 * (1 - x[0]), 9);
  expect([y, z]).toEqual([[0, 1, 0, 0], [0, 0, 1, 0]]);
  await drag(page, "Scale along x", [-4, 0, 0], ["Shift"]);
  await page.mouse.up();
  await page.keyboard.up("Shift");
  const even = made(asked).at(-1)!.map;
  expect([even[1][1], even[2][2]]).toEqual([even[0][0], even[0][0]]);
});

test("a grip turns about its axis", async ({ page }) => {
  const asked = await open(page);
  await drag(page, "Rotate about z", [-4, 1, 0]);
  await page.mouse.up();
  await expect.poll(() => asked.filter(({ ask }) => ask.ask === "draft").length).toBe(2);
  const { map } = made(asked).at(-1)!;
  expect(map[0][0] ** 2 + map[1][0] ** 2).toBeCloseTo(1, 12);
  expect(map[1][0]).toBeGreaterThan(0.1);
  expect(map[2]).toEqual([0, 0, 1, 0]);
});

test("Escape takes a drag back; a click asks for the amount", async ({ page }) => {
  const asked = await open(page);
  await drag(page, "Move along x", [5, 0, 0]);
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await expect.poll(() => asked.some(({ ask }) => ask.ask === "abandon")).toBe(true);
  await page.getByRole("button", { name: "Rotate about z", exact: true }).click();
  const field = page.getByRole("textbox", { name: "Degrees about z" });
  await field.fill("nonsense");
  await field.press("Enter");
  await expect(field).toHaveAttribute("aria-invalid", "true");
  await field.fill("180/2");
  await field.press("Enter");
  await expect(field).toBeHidden();
  // A quarter turn about (3, 2).
  const { map } = made(asked).at(-1)!;
  expect(map[0].map((value) => Math.round(value * 1e9) / 1e9 + 0)).toEqual([0, -1, 0, 5]);
  expect(map[1].map((value) => Math.round(value * 1e9) / 1e9 + 0)).toEqual([1, 0, 0, -1]);
});

test("the keyboard alone moves, and a point has no grips that do nothing", async ({ page }) => {
  const asked = await open(page, true);
  await expect(page.getByRole("button", { name: "Rotate about z", exact: true })).toBeHidden();
  await expect(page.getByRole("button", { name: "Move freely", exact: true })).toBeHidden();
  await page.getByRole("button", { name: "Move along z", exact: true }).focus();
  await page.keyboard.press("ArrowUp");
  await expect.poll(() => made(asked).length).toBe(1);
  const { map } = made(asked)[0]!;
  expect(map[2][3]).toBeGreaterThan(0);
  expect([map[0][3], map[1][3]]).toEqual([0, 0]);
});

test("it goes where it is not wanted", async ({ page }) => {
  await open(page);
  await page.evaluate(() => window.test.settingsStore.setState({ gumball: false }));
  await expect(page.getByRole("group", { name: "Gumball" })).toBeHidden();
  await page.evaluate(() => window.test.settingsStore.setState({ gumball: true }));
  await expect(page.getByRole("group", { name: "Gumball" })).toBeVisible();
  await page.evaluate(() => window.test.select([]));
  await expect(page.getByRole("group", { name: "Gumball" })).toBeHidden();
});

test("no grip is too near to another to be hit, from wherever it is seen", async ({ page }) => {
  await open(page);
  const least = () =>
    page.locator(".viewport-grip:visible").evaluateAll((all) => {
      const middles = all.map((each) => each.getBoundingClientRect()).map(({ x, y, width, height }) => [x + width / 2, y + height / 2] as const);
      const gaps = middles.flatMap(([x, y], k) => middles.slice(k + 1).map(([u, v]) => Math.hypot(u - x, v - y)));
      return Math.min(...gaps);
    });
  await page.locator(".viewport-canvas").focus();
  for (let turn = 0; turn < 12; turn++) {
    expect(await least()).toBeGreaterThanOrEqual(23.9);
    await page.keyboard.press(turn % 3 === 2 ? "ArrowUp" : "ArrowLeft");
    await page.waitForTimeout(100);
  }
});
