import { expect, test, type Page } from "@playwright/test";

import type { Request } from "../../src/core/protocol/Request";
import type {} from "../../src/viewport/current";

const PORT = "0f8fad5b-d9cb-469f-a165-70867728950e";
const place = (page: Page, point: [number, number, number]) =>
  page.evaluate((at) => window.__studio!.viewport!.place(at)!, point);

test.describe("fingers", () => {
  test.use({ hasTouch: true });

  test("one turns, two move and zoom, a tap selects", async ({ page }) => {
    await page.goto("/tests/viewport/page.html?scene=box&bare");
    await page.waitForFunction(() => (window.__studio?.viewport?.stats()?.frames ?? 0) > 0);
    const client = await page.context().newCDPSession(page);
    const touch = (type: "touchStart" | "touchMove" | "touchEnd", ...points: [number, number][]) =>
      client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    const [corner, middle] = [await place(page, [5, 5, 5]), await place(page, [0, 0, 0])];
    await touch("touchStart", [300, 200]);
    await touch("touchMove", [330, 200]);
    await touch("touchMove", [360, 200]);
    await touch("touchEnd");
    const turned = await place(page, [5, 5, 5]);
    expect(Math.hypot(turned[0] - corner[0], turned[1] - corner[1])).toBeGreaterThan(20);
    const size = async () => {
      const [a, b] = [await place(page, [0, 0, -5]), await place(page, [0, 0, 5])];
      return Math.hypot(a[0] - b[0], a[1] - b[1]);
    };
    const before = await size();
    await touch("touchStart", [280, 240], [360, 240]);
    await touch("touchMove", [240, 240], [400, 240]);
    await touch("touchEnd");
    expect(await size()).toBeGreaterThan(before * 1.6);
    const still = await place(page, [0, 0, 0]);
    expect(Math.hypot(still[0] - middle[0], still[1] - middle[1])).toBeLessThan(60);
    await page.touchscreen.tap(...(await place(page, [0, 0, 0])));
    expect(await page.evaluate(() => [...window.test.uiStore.getState().selection])).toEqual(["box"]);
  });
});

test.describe("points of a Point parameter", () => {
  /** A session that keeps two points, and what was asked of it. */
  async function open(page: Page, points = ["{0, 0, 0}", "{2, 3, 1}"]): Promise<Request[]> {
    const asked: Request[] = [];
    let text = points;
    await page.routeWebSocket(/\/socket/, (socket) => {
      socket.onMessage((data) => {
        const request = JSON.parse(String(data)) as Request;
        asked.push(request);
        const { seq, ask } = request;
        if (ask.ask === "rows") {
          const rows = [{ is: "path", path: "{0}", items: 2 }, ...text.map((item, index) => ({ is: "item", index, text: item }))];
          socket.send(JSON.stringify({ event: "rows", seq, page: { from: 0, total: 3, rows } }));
          return;
        }
        if (ask.ask === "edit" && ask.edit.do === "keep") text = ask.edit.values?.split("\n").slice(1) ?? [];
        socket.send(JSON.stringify({ event: "done", seq, revision: 1, made: [] }));
      });
    });
    await page.goto("/tests/viewport/page.html?bare");
    await page.evaluate((id) => {
      const { join, documentStore, feed, select } = window.test;
      join("d", "t");
      const port = { id, sources: [], kept: 2 };
      const object = { id, component: "fbac3e32-f100-4292-8692-77240a42fd1a", kind: "parameter", nickname: "Pt", inputs: [port], outputs: [port] };
      documentStore.setState({ objects: new Map([[id, object as never]]) });
      feed({ object: id, bounds: [[-10, -10, 0], [10, 10, 5]], parts: [{ kind: "points", positions: [0, 0, 0, 2, 3, 1] }] });
      return new Promise<void>((resolve) => setTimeout(() => (select([id]), resolve()), 300));
    }, PORT);
    await expect(page.locator(".viewport-handle")).toHaveCount(2);
    return asked;
  }

  const kept = (asked: Request[]) =>
    asked.flatMap(({ ask }) => (ask.ask === "edit" && ask.edit.do === "keep" ? [{ values: ask.edit.values, gesture: ask.gesture }] : []));

  test("are dragged in the plane of the view, on the grid, as one step for Undo", async ({ page }) => {
    const asked = await open(page);
    const handle = page.getByRole("button", { name: "Point 1 of Pt, at 2, 3, 1" });
    await expect(handle).toBeVisible();
    const from = await place(page, [2, 3, 1]);
    const to = await place(page, [5.02, -0.97, 1]);
    await page.mouse.move(...from);
    await page.mouse.down();
    await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, { steps: 3 });
    await page.mouse.move(...to, { steps: 3 });
    await page.mouse.up();
    await expect(page.getByRole("button", { name: /Point 1 of Pt, at 5, -1, 1/ })).toBeVisible();
    const edits = kept(asked);
    expect(edits.at(-1)?.values).toBe("{0}\n{0, 0, 0}\n{5, -1, 1}");
    expect(new Set(edits.map(({ gesture }) => gesture)).size).toBe(1);
    expect(asked.some(({ ask }) => ask.ask === "rows" && ask.exact)).toBe(true);
    expect(asked.filter(({ ask }) => ask.ask === "draft").map(({ ask }) => ask.ask === "draft" && ask.on)).toEqual([true, false]);
  });

  test("keep all digits of what is not moved, and go along one axis when they are held to it", async ({ page }) => {
    const asked = await open(page, ["{0, 0, 0}", "{2, 3, 1.0000000000000002}"]);
    const from = await place(page, [2, 3, 1]);
    const to = await place(page, [6, 5, 1]);
    await page.mouse.move(...from);
    await page.mouse.down();
    await page.mouse.move(from[0] + 5, from[1], { steps: 2 });
    await page.keyboard.press("x");
    await page.mouse.move(...to, { steps: 3 });
    await expect(page.locator(".viewport-readout")).toContainText(/^x · /);
    await page.mouse.up();
    await expect.poll(() => kept(asked).at(-1)?.values?.split("\n")[2]).toMatch(/^\{[4-8](\.\d)?, 3, 1\.0000000000000002\}$/);
  });

  test("go back with Escape, and are moved with the keyboard alone", async ({ page }) => {
    const asked = await open(page);
    const [x, y] = await place(page, [2, 3, 1]);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 60, y, { steps: 3 });
    await page.keyboard.press("Escape");
    await page.mouse.up();
    await expect.poll(() => asked.some(({ ask }) => ask.ask === "abandon")).toBe(true);
    await page.locator(".viewport-handle").first().focus();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("PageUp");
    await expect.poll(() => kept(asked).at(-1)?.values?.split("\n")[1]).toMatch(/^\{(0\.1|1|10), 0, \1\}$/);
  });
});
