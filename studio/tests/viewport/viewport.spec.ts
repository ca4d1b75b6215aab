import { expect, test, type Page } from "@playwright/test";
import AxeBuilder from "@axe-core/playwright";

import type {} from "../../src/viewport/current";

type Colour = readonly [number, number, number, number];

/** The page with a scene, drawn, without toolbar: 640 × 480 pixels of viewport. */
async function open(page: Page, query: string): Promise<void> {
  page.on("pageerror", (error) => expect(error.message).toBe(""));
  await page.goto(`/tests/viewport/page.html?${query}`);
  await page.waitForFunction(() => (window.__studio?.viewport?.stats()?.frames ?? 0) > 0);
}

const stats = (page: Page) => page.evaluate(() => window.__studio!.viewport!.stats()!);
const pixel = (page: Page, x: number, y: number): Promise<Colour> =>
  page.evaluate(([u, v]) => window.__studio!.viewport!.pixel(u!, v!)!, [x, y]);
const place = (page: Page, point: [number, number, number]) =>
  page.evaluate((at) => window.__studio!.viewport!.place(at)!, point);
const selection = (page: Page) => page.evaluate(() => [...window.test.uiStore.getState().selection]);
const set = (page: Page, settings: Record<string, unknown>) =>
  page.evaluate((values) => window.test.settingsStore.setState(values), settings);

const isRed = ([r, g, b]: Colour) => r > g + 25 && r > b + 25;
const isGreen = ([r, g, b]: Colour) => g > r + 15 && g > b + 15;
const isGrey = ([r, g, b]: Colour) => Math.max(r, g, b) - Math.min(r, g, b) < 14;

test.describe("what is drawn", () => {
  test("is counted, fits the view, and is red until it is selected", async ({ page }) => {
    await open(page, "scene=box&bare");
    const seen = await stats(page);
    expect(seen).toMatchObject({ objects: 1, parts: 2, triangles: 12, segments: 12 });
    expect(seen.bounds).toEqual([[-5, -5, -5], [5, 5, 5]]);
    const [x, y] = await place(page, [-3, -5, 2]);
    expect(isRed(await pixel(page, x, y))).toBe(true);
    await page.evaluate(() => window.test.select(["box"]));
    expect(isGreen(await pixel(page, x, y))).toBe(true);
    await page.evaluate(() => window.test.select([]));
    expect(isRed(await pixel(page, x, y))).toBe(true);
  });

  test("in wireframe are curves alone, and hidden objects are not drawn", async ({ page }) => {
    await open(page, "scene=box&bare");
    await set(page, { shown: { grid: false, edges: true, isocurves: true, points: true, controlPoints: true, texts: true } });
    const middle = await place(page, [-2, -5, 1]);
    const background = await pixel(page, 5, 5);
    await set(page, { mode: "wireframe" });
    expect(await pixel(page, ...middle)).toEqual(background);
    const edge = await place(page, [-5, -5, 0]);
    expect(isRed(await pixel(page, ...edge))).toBe(true);
    await page.evaluate(() => {
      const objects = new Map([["box", { hidden: true } as never]]);
      window.test.documentStore.setState({ objects });
    });
    expect(await pixel(page, ...edge)).toEqual(background);
  });

  test("is not drawn again while nothing changes", async ({ page }) => {
    await open(page, "scene=everything&bare");
    await page.waitForTimeout(500);
    const before = (await stats(page)).frames;
    await page.waitForTimeout(1000);
    expect((await stats(page)).frames).toBe(before);
  });

  test("goes when its object goes, and frees what it took", async ({ page }) => {
    await open(page, "scene=everything&bare");
    const before = await stats(page);
    await page.evaluate(() => {
      const names = window.test.scenes["everything"]!().map(({ object }) => [object, null] as [string, null]);
      window.test.takePreview({ event: "preview", solution: 99, draft: false, objects: names });
      window.__studio!.viewport!.draw();
    });
    const after = await stats(page);
    expect(before.geometries).toBeGreaterThan(3);
    expect(after).toMatchObject({ objects: 0, parts: 0, triangles: 0, bounds: null, drawables: 0 });
    expect(after.geometries).toBe(1);
  });

  test("of many small objects is drawn in few goes", async ({ page }) => {
    await open(page, "scene=boxes&bare");
    const seen = await stats(page);
    expect(seen).toMatchObject({ objects: 400, triangles: 4800 });
    expect(seen.drawables).toBeLessThan(5);
  });

  test("is sharp far away from the origin", async ({ page }) => {
    await open(page, "scene=far&bare");
    const [a, b] = [await place(page, [5e6, 4e6, 300]), await place(page, [5e6, 4e6, 310])];
    expect(Math.hypot(a[0] - b[0], a[1] - b[1])).toBeGreaterThan(80);
    const [x, y] = await place(page, [5e6 + 3, 4e6, 306]);
    expect(isRed(await pixel(page, x, y))).toBe(true);
  });

  test("comes back after the graphics card lost it", async ({ page }) => {
    await open(page, "scene=everything&bare");
    const [x, y] = await place(page, [6, -13, 3]);
    const before = await pixel(page, x, y);
    await page.evaluate(async () => {
      const gl = document.querySelector<HTMLCanvasElement>(".viewport-canvas")!.getContext("webgl2")!;
      const lose = gl.getExtension("WEBGL_lose_context")!;
      lose.loseContext();
      await new Promise((resolve) => setTimeout(resolve, 100));
      lose.restoreContext();
      await new Promise((resolve) => setTimeout(resolve, 300));
    });
    expect((await stats(page)).isLost).toBe(false);
    expect(await pixel(page, x, y)).toEqual(before);
  });

  test("is here again when the pane comes and goes, many times", async ({ page }) => {
    await open(page, "scene=box&bare");
    for (let round = 0; round < 20; round++) {
      await page.evaluate(() => window.test.show(false));
      await page.waitForFunction(() => window.__studio?.viewport?.stats() === undefined);
      await page.evaluate(() => window.test.show(true));
      await page.waitForFunction(() => (window.__studio?.viewport?.stats()?.frames ?? 0) > 0);
    }
    expect(await stats(page)).toMatchObject({ objects: 1, triangles: 12, isLost: false });
    expect(isRed(await pixel(page, ...(await place(page, [-3, -5, 2]))))).toBe(true);
  });

  test("may be anything that fits the layout", async ({ page }) => {
    await open(page, "bare");
    const kinds = ["mesh", "edges", "isocurves", "curves", "arrows", "points", "controlPoints", "planes", "texts"];
    for (const size of [0, 1e-30, 1e-6, 1e12, 1e30, 3e38]) {
      await page.evaluate(
        ([kinds, size]) => {
          const { feed, select, settingsStore } = window.test;
          const numbers = (count: number) => Array.from({ length: count }, (_, at) => Math.sin(at * 7) * size);
          feed(
            ...kinds.map((kind) => ({
              object: kind,
              origin: [size, -size, size * 2] as [number, number, number],
              bounds: null,
              parts: [
                { kind, positions: [] },
                { kind, positions: numbers(18), indices: kind === "texts" ? undefined : [0, 0, 0, 0, 1, 1], texts: Array(6).fill("x") },
                { kind, positions: numbers(18), normals: numbers(18), values: numbers(6), texts: Array(6).fill("y"), width: 1e9, textHeight: size },
              ].map(({ indices, ...part }) => (indices ? { ...part, indices } : part)),
            })),
          );
          select(kinds);
          for (const analysis of ["gaussian", "zebra", "none"] as const) {
            settingsStore.setState({ analysis, comb: true, circle: true });
            window.__studio!.viewport!.draw();
          }
        },
        [kinds, size] as const,
      );
      await page.mouse.move(300 + Math.log10(size + 1), 240);
      await page.mouse.wheel(0, -300);
      await drag(page, [300, 200], [340, 260], "right");
      await drag(page, [100, 100], [500, 400], "left");
      await page.keyboard.press("Home");
      expect((await stats(page)).isLost).toBe(false);
    }
    // And something usual is seen again after all that.
    await page.evaluate((kinds) => {
      window.test.takePreview({ event: "preview", solution: 999, draft: false, objects: kinds.map((kind) => [kind, null]) });
      window.test.select([]);
      window.test.feed(...window.test.scenes["box"]!());
    }, kinds);
    await page.locator(".viewport-canvas").focus();
    await page.keyboard.press("Home");
    await page.waitForTimeout(600);
    expect(isRed(await pixel(page, ...(await place(page, [-3, -5, 2]))))).toBe(true);
  });

  test("bytes that are no preview change nothing", async ({ page }) => {
    await open(page, "scene=box&bare");
    await page.evaluate(() => {
      window.test.takeGeometry(new ArrayBuffer(0));
      window.test.takeGeometry(new TextEncoder().encode("<script>alert(1)</script>".repeat(9)).buffer);
    });
    expect(await stats(page)).toMatchObject({ objects: 1, triangles: 12 });
  });
});

test.describe("hands", () => {
  test("a click selects what is under it, in the void nothing; Shift adds, Ctrl removes", async ({ page }) => {
    await open(page, "scene=everything&bare");
    const [ball, box] = [await place(page, [6, -13, 2.2]), await place(page, [13.5, -8, 2.5])];
    await page.mouse.click(...at(ball));
    expect(await selection(page)).toEqual(["ball"]);
    await page.keyboard.down("Shift");
    await page.mouse.click(...at(box));
    await page.keyboard.up("Shift");
    expect(await selection(page)).toEqual(["ball", "box"]);
    await page.keyboard.down("Control");
    await page.mouse.click(...at(ball));
    await page.keyboard.up("Control");
    expect(await selection(page)).toEqual(["box"]);
    await page.mouse.click(5, 470);
    expect(await selection(page)).toEqual([]);
  });

  test("points and curves can be hit, and what is pointed at is told of", async ({ page }) => {
    await open(page, "scene=everything&bare");
    await page.mouse.move(...at(await place(page, [0, 0, 6])));
    await expect.poll(() => page.evaluate(() => window.test.uiStore.getState().hovered)).toBe("points");
    await page.mouse.move(...at(await place(page, [12 + 2.5, 9, 0])));
    await expect.poll(() => page.evaluate(() => window.test.uiStore.getState().hovered)).toBe("helix");
    await page.mouse.move(5, 470);
    await expect.poll(() => page.evaluate(() => window.test.uiStore.getState().hovered)).toBeUndefined();
  });

  test("a window to the right takes what it holds, to the left what it touches", async ({ page }) => {
    await open(page, "scene=everything&bare");
    const [x, y] = await place(page, [6, -13, 2.2]);
    await drag(page, [x - 60, y - 60], [x + 60, y + 60], "left");
    expect(await selection(page)).toEqual(["ball"]);
    await drag(page, [x + 4, y + 4], [x - 4, y - 4], "left");
    expect(await selection(page)).toEqual(["ball"]);
    await drag(page, [x - 4, y - 4], [x + 4, y + 4], "left");
    expect(await selection(page)).toEqual([]);
  });

  test("the right button turns, with Shift it moves; the wheel zooms to the pointer", async ({ page }) => {
    await open(page, "scene=box&bare");
    const corner: [number, number, number] = [5, 5, 5];
    const [start, middle] = [await place(page, corner), await place(page, [0, 0, 0])];
    await page.keyboard.down("Shift");
    await drag(page, [300, 200], [350, 170], "right");
    await page.keyboard.up("Shift");
    const moved = await place(page, [0, 0, 0]);
    expect(moved[0] - middle[0]).toBeCloseTo(50, 0);
    expect(moved[1] - middle[1]).toBeCloseTo(-30, 0);
    await drag(page, [300, 200], [400, 200], "right");
    const turned = await place(page, corner);
    expect(Math.hypot(turned[0] - start[0] - 50, turned[1] - start[1] + 30)).toBeGreaterThan(40);
    const under = await place(page, [-5, -5, 5]);
    await page.mouse.move(...at(under));
    await page.mouse.wheel(0, -400);
    await page.waitForTimeout(100);
    const after = await place(page, [-5, -5, 5]);
    expect(Math.hypot(after[0] - under[0], after[1] - under[1])).toBeLessThan(6);
  });

  test("the keyboard turns, moves and zooms, and the cube looks from each side", async ({ page }) => {
    await page.emulateMedia({ reducedMotion: "reduce" });
    await open(page, "scene=box&bare");
    await page.locator(".viewport-canvas").focus();
    const before = await place(page, [5, 5, 5]);
    await page.keyboard.press("ArrowLeft");
    expect(await place(page, [5, 5, 5])).not.toEqual(before);
    const middle = await place(page, [0, 0, 0]);
    await page.keyboard.press("Shift+ArrowRight");
    expect((await place(page, [0, 0, 0]))[0]).toBeCloseTo(middle[0] - 40, 0);
    await page.keyboard.press("Home");
    await page.getByRole("button", { name: "Look from: Front" }).press("Enter");
    const [a, b] = [await place(page, [-5, -5, -5]), await place(page, [5, -5, 5])];
    expect(a[0]).toBeLessThan(b[0]);
    expect(a[1]).toBeGreaterThan(b[1]);
    const edge = await place(page, [5, 5, 5]);
    expect(Math.abs(edge[0] - 320)).toBeLessThan(b[0] - 320);
  });
});

test.describe("ways to look", () => {
  test("four views show Top, Perspective, Front and Right", async ({ page }) => {
    await open(page, "scene=torus&bare");
    await set(page, { layout: "four" });
    for (const name of ["Top", "Perspective", "Front", "Right"]) {
      await expect(page.getByRole("button", { name, exact: true })).toBeVisible();
    }
    // In Front, the torus is as wide as 26 and as high as 6: red at its end, nothing above it.
    const [x, y] = [160, 360];
    expect(isRed(await pixel(page, x + 90, y))).toBe(true);
    expect(isGrey(await pixel(page, x + 40, y - 90))).toBe(true);
  });

  test("false colours run from the inside of a torus to its outside", async ({ page }) => {
    await open(page, "scene=torus");
    await set(page, { analysis: "gaussian" });
    const legend = page.getByRole("region", { name: "Colours of Gaussian curvature" });
    await expect(legend).toBeVisible();
    const [r, g, b] = await pixel(page, ...(await place(page, [0, -13, 0])));
    expect(r > g && r > b).toBe(true);
    await legend.getByLabel("Least value").fill("0.02");
    await legend.getByLabel("Least value").press("Enter");
    // Beside the isocurve there.
    const typed = await pixel(page, ...(await place(page, [0.8, -10.47, 2.95])));
    expect(typed[2]).toBeGreaterThan(typed[0]);
    await legend.getByRole("button", { name: "Fit to the model" }).click();
    await expect(legend.getByLabel("Least value")).toHaveValue(/-0\.04/);
  });

  test("what is cut away is neither seen nor picked, and the plane is moved by hand and by keys", async ({ page }) => {
    await open(page, "scene=box&bare");
    await page.mouse.click(...at(await place(page, [-3, -5, 2])));
    expect(await selection(page)).toEqual(["box"]);
    await page.evaluate(() => window.test.select([]));
    const front = await place(page, [-3, -5, 2]);
    await page.mouse.move(5, 500);
    await expect.poll(async () => isRed(await pixel(page, ...front))).toBe(true);
    await set(page, { section: { isOn: true, normal: [0, 0, 1], at: -6 }, shown: { grid: false, edges: true, isocurves: true, points: true, controlPoints: true, texts: true } });
    expect(isRed(await pixel(page, ...front))).toBe(false);
    await page.mouse.click(...at(front));
    expect(await selection(page)).toEqual([]);
    const handle = page.getByRole("button", { name: "Section plane, -6 from the origin" });
    await handle.focus();
    await page.keyboard.press("ArrowUp");
    const before = await page.evaluate(() => window.test.settingsStore.getState().section.at!);
    expect(before).toBeGreaterThan(-6);
    await expect(page.getByRole("button", { name: `Section plane, ${before} from the origin` })).toBeVisible();
    const box = (await page.locator(".viewport-section-handle").boundingBox())!;
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2 - 80, { steps: 4 });
    await page.mouse.up();
    expect(await page.evaluate(() => window.test.settingsStore.getState().section.at!)).toBeGreaterThan(before + 1);
    await set(page, { section: { isOn: false, normal: [0, 0, 1], at: undefined } });
    expect(isRed(await pixel(page, ...front))).toBe(true);
  });

  test("texts stand where they belong, and scripts in them are text", async ({ page }) => {
    await open(page, "scene=box&bare");
    await page.evaluate(() => {
      const nasty = "<img src=x onerror=document.title='broken'>";
      window.test.feed({ object: "tag", parts: [{ kind: "texts", positions: [5, 5, 5], texts: [nasty] }] });
    });
    const text = page.locator(".viewport-texts span");
    await expect(text).toHaveText("<img src=x onerror=document.title='broken'>");
    const [x, y] = await place(page, [5, 5, 5]);
    const box = (await text.boundingBox())!;
    expect(Math.abs(box.x - x)).toBeLessThan(2);
    expect(Math.abs(box.y + box.height - y)).toBeLessThan(2);
    expect(await page.title()).toBe("The viewport by itself");
  });

  test("a picture is saved", async ({ page }) => {
    await open(page, "scene=everything");
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("button", { name: "Save picture" }).click(),
    ]);
    expect(download.suggestedFilename()).toBe("viewport.png");
  });

  for (const theme of ["light", "dark"]) {
    test(`nothing stands in the way of anybody (${theme})`, async ({ page }) => {
      await open(page, `scene=everything${theme === "dark" ? "&dark" : ""}`);
      await page.getByRole("button", { name: "Analysis" }).click();
      await set(page, { analysis: "mean", layout: "four", comb: true });
      const { violations } = await new AxeBuilder({ page }).include("#root").analyze();
      const grave = violations.filter(({ impact }) => impact === "serious" || impact === "critical");
      expect(grave.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([]);
    });
  }
});

test.describe("pictures", () => {
  // Letters look different on every machine.
  const bare = { content: ".viewport-texts, .viewport-frame { display: none }" };
  for (const mode of ["shaded", "wireframe", "ghosted", "rendered", "technical"]) {
    test(mode, async ({ page }) => {
      await open(page, "scene=everything&bare");
      await page.addStyleTag(bare);
      await set(page, { mode });
      await page.evaluate(() => window.test.select(["box"]));
      await page.evaluate(() => window.__studio!.viewport!.draw());
      await expect(page.locator(".viewport-canvas")).toHaveScreenshot(`${mode}.png`);
    });
  }
  test("zebra", async ({ page }) => {
    await open(page, "scene=everything&bare");
    await page.addStyleTag(bare);
    await set(page, { analysis: "zebra" });
    await expect(page.locator(".viewport-canvas")).toHaveScreenshot("zebra.png");
  });
});

function at([x, y]: readonly [number, number]): [number, number] {
  return [x, y];
}

async function drag(page: Page, from: [number, number], to: [number, number], button: "left" | "right"): Promise<void> {
  await page.mouse.move(...from);
  await page.mouse.down({ button });
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
  await page.mouse.move(...to);
  await page.mouse.up({ button });
}
