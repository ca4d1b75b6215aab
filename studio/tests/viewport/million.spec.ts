import { expect, test } from "@playwright/test";

import type {} from "../../src/viewport/current";

/** How often the mesh changes; the figure to show is for 100. */
const CHANGES = Number(process.env.CHANGES ?? 8);

/**
 * A mesh of a million triangles changes: from its bytes to the picture, beside the least that the same machine needs
 * for the same mesh in one draw call.
 */
test("a mesh of a million triangles changes, and nothing piles up", async ({ page }) => {
  test.setTimeout(60_000 + CHANGES * 10_000);
  await page.goto("/tests/viewport/page.html?bare");
  await page.waitForFunction(() => window.__studio?.viewport?.stats());
  const found = await page.evaluate(async (changes) => {
    const { writeFrame, writePreview, takeGeometry, takePreview, million, floor } = window.test;
    const gl = document.querySelector<HTMLCanvasElement>(".viewport-canvas")!.getContext("webgl2")!;
    const ready = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    const [ours, least, decode, heap]: [number[], number[], number[], number[]] = [[], [], [], []];
    const measureFloor = floor();
    for (let change = 0; change < changes; change++) {
      const mesh = million(change * 0.1);
      least.push(measureFloor(mesh));
      const { hash, frame } = writeFrame(`${change}`, writePreview({ object: "million", parts: [{ kind: "mesh", ...mesh }] }));
      // The fine picture of the change before must not be in the way.
      await new Promise((resolve) => setTimeout(resolve, 500));
      ready();
      const start = performance.now();
      takeGeometry(frame);
      takePreview({ event: "preview", solution: change, draft: false, objects: [["million", hash]] });
      decode.push(performance.now() - start);
      await new Promise((resolve) => requestAnimationFrame(resolve));
      ready();
      ours.push(performance.now() - start);
      const { memory } = performance as unknown as { memory?: { usedJSHeapSize: number } };
      heap.push((memory?.usedJSHeapSize ?? 0) / 1e6);
    }
    const median = (list: number[]) => [...list].sort((a, b) => a - b)[list.length >> 1]!;
    return { ours: median(ours), floor: median(least), decode: median(decode), heap, stats: window.__studio!.viewport!.stats()! };
  }, CHANGES);
  const { ours, floor, decode, heap, stats } = found;
  console.log(`picture ${ours.toFixed(0)} ms, floor ${floor.toFixed(0)} ms, decode ${decode.toFixed(0)} ms, heap ${heap.map(Math.round).join(" ")} MB`);
  expect(stats).toMatchObject({ objects: 1, triangles: 996_872, geometries: 2 });
  expect(ours).toBeLessThan(floor + 1000);
  const half = heap.slice(heap.length >> 1);
  expect(Math.max(...half)).toBeLessThan(Math.max(...heap.slice(0, heap.length >> 1)) + 60);
});

test("a surface of a million triangles is picked through a tree that is built beside the page", async ({ page }) => {
  await page.goto("/tests/viewport/page.html?bare");
  await page.waitForFunction(() => window.__studio?.viewport?.stats());
  await page.evaluate(() => {
    const { feed, million } = window.test;
    feed({ object: "million", parts: [{ kind: "mesh", ...million(0) }] });
  });
  await expect
    .poll(
      async () => {
        await page.mouse.move(320 + Math.random() * 4, 240);
        await page.waitForTimeout(200);
        return page.evaluate(() => window.test.uiStore.getState().hovered);
      },
      { timeout: 60_000 },
    )
    .toBe("million");
  const times = await page.evaluate(() => window.test.timePick(320, 240));
  console.log(`a ray through the tree ${times.tree.toFixed(3)} ms, through all triangles ${times.brute.toFixed(1)} ms, drawing all once ${times.draw.toFixed(0)} ms`);
  expect(times.tree).toBeLessThan(times.brute);
});
