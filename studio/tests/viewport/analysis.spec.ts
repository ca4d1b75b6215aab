import { expect, test, type Page } from "@playwright/test";

import type { Ask } from "../../src/core/protocol/Ask";
import type { Event } from "../../src/core/protocol/Event";
import type { Request } from "../../src/core/protocol/Request";
import type {} from "../../src/viewport/current";

/** The page with a scene and a session that remembers what it is asked. */
async function open(page: Page): Promise<Ask[]> {
  const asked: Ask[] = [];
  await page.routeWebSocket(/\/socket/, (socket) => {
    socket.onMessage((data) => {
      const { seq, ask } = JSON.parse(String(data)) as Request;
      asked.push(ask);
      socket.send(JSON.stringify({ event: "done", seq, revision: 1, made: [] }));
      if (ask.ask !== "probe") return;
      const circle = { centre: [12, 9, 0], radius: 2.5, x: [1, 0, 0], y: [0, 1, 0] };
      const bend = { is: "curve", tangent: [0, 1, 0], curvature: 0.4, circle };
      const probes = ask.probes.map(() => ({ member: 0, parameter: [0.25], point: [14.5, 9, 0], bend }));
      socket.send(JSON.stringify({ event: "probed", solution: 1, round: ask.round, probes }));
    });
  });
  await page.goto("/tests/viewport/page.html?scene=everything&bare");
  await page.waitForFunction(() => (window.__studio?.viewport?.stats()?.frames ?? 0) > 0);
  await page.evaluate(() => {
    const pieces = [{ output: 0, path: "{0}", index: 3, start: 0, count: 480 }];
    const helix = window.test.scenes["everything"]!().find(({ object }) => object === "helix")!;
    window.test.feed({ ...helix, parts: helix.parts.map((part) => ({ ...part, pieces })) });
    window.test.documentStore.setState({ objects: new Map([["helix", { nickname: "Helix" } as never]]) });
    window.test.join("d", "t");
  });
  return asked;
}

const set = (page: Page, settings: Record<string, unknown>) =>
  page.evaluate((values) => window.test.settingsStore.setState(values), settings);
const objects = (page: Page) => page.evaluate(() => window.__studio!.viewport!.stats()!.objects);
const at = async (page: Page, point: [number, number, number]) => {
  const [x, y] = await page.evaluate((of) => window.__studio!.viewport!.place(of)!, point);
  const box = (await page.locator(".viewport-canvas").boundingBox())!;
  return [box.x + x, box.y + y] as const;
};

test("combs are asked for as settings and selection have them, and drawn as they come", async ({ page }) => {
  const asked = await open(page);
  const before = await objects(page);
  await page.evaluate(() => window.test.select(["helix", "nothing"]));
  await set(page, { comb: true, combTeeth: 7, combScale: 30, controls: true });
  const comb = { teeth: 7, length: 0.3, surfaces: false };
  const analysis = { objects: ["helix"], comb, circles: 0, controls: true, isocurves: null, colours: false };
  await expect.poll(() => asked.at(-1)).toEqual({ ask: "analyse", analysis });
  await page.evaluate(() => {
    const { writeFrame, writePreview, takeGeometry, takePreview, takeAnalysis } = window.test;
    const parts = [{ kind: "comb", positions: [14.5, 9, 0, 17, 9, 0] }, { kind: "controlPoints", positions: [14.5, 9, 0] }];
    const { hash, frame } = writeFrame("comb", writePreview({ object: "helix", parts }));
    takeGeometry(frame);
    const measure = { scale: 5, sharpest: 0.4, at: [14.5, 9, 0] as [number, number, number] };
    const objects: [string, string | null][] = [["helix", hash]];
    const event: Event = { event: "analysed", solution: 1, draft: false, objects, comb: measure, leftOut: ["too many"] };
    takePreview(event);
    takeAnalysis(event);
  });
  await expect.poll(() => objects(page)).toBe(before + 1);
  await expect(page.getByRole("region", { name: "Curvature comb" })).toContainText("Smallest radius 2.5");
  await expect(page.getByText("too many")).toBeVisible();
  // What stands beside the model is not picked: a click on a tooth is a click into the void behind it.
  await page.mouse.click(...(await at(page, [16.9, 9, 0])));
  expect(await page.evaluate(() => [...window.test.uiStore.getState().selection])).toEqual([]);
  await set(page, { comb: false, controls: false });
  await expect.poll(() => asked.at(-1)).toEqual({ ask: "analyse", analysis: null });
});

test("the circle under the pointer is the session's, and stays where it is kept", async ({ page }) => {
  const asked = await open(page);
  const before = await objects(page);
  await set(page, { circle: true });
  const foot = await at(page, [14.5, 9, 0]);
  await page.mouse.move(...foot);
  await expect.poll(() => objects(page)).toBe(before + 1);
  const probe = asked.findLast((ask) => ask.ask === "probe");
  expect(probe?.ask === "probe" && probe.probes[0]).toMatchObject({ object: "helix", output: 0, path: "{0}", index: 3, at: { is: "near" } });
  const places = page.getByRole("region", { name: "Curvature at places" });
  await expect(places).toContainText("0.4");
  await page.keyboard.down("Alt");
  await page.mouse.down();
  await page.mouse.up();
  await page.keyboard.up("Alt");
  await set(page, { circle: false });
  await page.mouse.move(20, 20);
  await expect(places.getByRole("button", { name: "Remove this place of Helix" })).toBeVisible();
  // A place that is kept goes by its parameter, so that it stays on a curve that changes.
  await expect
    .poll(() => {
      const last = asked.findLast((ask) => ask.ask === "probe");
      return last?.ask === "probe" && last.probes.map((each) => each.at);
    })
    .toEqual([{ is: "parameter", member: 0, parameter: [0.25] }]);
  await places.getByRole("button", { name: "Remove this place of Helix" }).click();
  await expect.poll(() => objects(page)).toBe(before);
});
