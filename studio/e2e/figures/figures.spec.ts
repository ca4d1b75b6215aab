/**
 * Every figure of the book: it starts, gives its numbers, and moves, by the keyboard alone. `make test-figures` takes all pages;
 * `make test-browser` a few of them, one of each sort.
 */
import type { Locator } from "@playwright/test";

import { isAccessible } from "../access";
import { expect, test } from "../test";
import { exercisesOf, expectedOf, pagesOf } from "./book";
import { Driven } from "./drive";

/** Arrows, a formula without a picture, a matrix, a curve with steps, knots, false colours, a torus's parameters, a page of our own. */
const SAMPLE = ["V1", "V8", "M1", "C9", "N2", "N10", "more/surface-parameters", "more/frenet-frame"];
const isWhole = Boolean(process.env.ALL_FIGURES);
const NARROW = { width: 390, height: 844 };

test.describe.configure({ timeout: 240_000 });

const pages = isWhole ? [...pagesOf(), ...pagesOf("de/").map((folder) => `de/${folder}`)] : SAMPLE;

for (const folder of pages) {
  const isOwn = !folder.startsWith("de/");
  test(`the figures of ${folder}`, async ({ page }, info) => {
    await page.goto(`/learn/${folder}/`);
    const count = await page.locator("katydid-figure").count();
    expect(count, "figures").toBeGreaterThan(0);
    const notes: string[] = [];
    for (let place = 0; place < count; place++) {
      const figure = new Driven(page, place);
      await figure.start();
      const { id, definition } = figure.data;
      const compared = await figure.compare(expectedOf(definition));
      expect.soft(compared, `${id}: values of ${definition}`).toBeGreaterThan(0);
      await figure.rest();
      await figure.element.screenshot({ path: info.outputPath(`${id}.png`) });
      notes.push(...(await movesByControls(figure)), ...(await movesByPoints(figure)), ...(await widgetsWork(figure)));
    }
    expect.soft(notes.filter((note) => note.includes("nothing")), "what moves nothing").toEqual([]);
    if (isOwn) for (const exercise of exercisesOf(folder)) await isSolved(page.locator(`#${exercise.id}.exercise`), exercise.values);
    const steps = page.locator(".steps");
    for (let k = 0; k < (await steps.count()); k++) await stepsGo(steps.nth(k));
    await isAccessible(page);
    await page.screenshot({ path: info.outputPath("page.png"), fullPage: true });
    await page.setViewportSize(NARROW);
    await page.waitForTimeout(300);
    await page.screenshot({ path: info.outputPath("narrow.png"), fullPage: true });
    expect.soft(await overflowing(page.locator("body")), "wider than a narrow window").toEqual([]);
  });
}

/** Each control, by its keys; then all back. */
async function movesByControls(figure: Driven): Promise<string[]> {
  const told: string[] = [];
  const controls = figure.element.locator(".controls");
  if (figure.data.controls.length === 0) return [];
  await figure.rest();
  const before = await figure.words();
  for (const { name, slider } of figure.data.controls) {
    const input = controls.locator(`input[data-name="${name}"]`);
    const keys = slider ? [slider.value < slider.max ? "ArrowRight" : "ArrowLeft", "End", "Home"] : ["Space"];
    let shown: string | undefined;
    for (const key of keys) {
      shown = await figure.moves(() => input.press(key));
      if (shown) break;
    }
    told.push(`${figure.data.id}: ${name} moves ${shown ?? "nothing"}`);
    await figure.rest();
  }
  await controls.locator("button").press("Enter");
  await expect.poll(() => figure.words(), `${figure.data.id}: back to the start`).toBe(before);
  return told;
}

/** Each point that can be dragged, by arrow keys, there and back. */
async function movesByPoints(figure: Driven): Promise<string[]> {
  const told: string[] = [];
  const grips = figure.element.locator(".grip");
  const count = await grips.count();
  if (figure.data.drag.length > 0 && count < figure.data.drag.length) told.push(`${figure.data.id}: of ${figure.data.drag.length} points ${count} can be dragged: nothing`);
  for (let k = 0; k < count; k++) {
    const grip = grips.nth(k);
    const name = await grip.textContent();
    let shown: string | undefined;
    for (const [there, back] of [["ArrowRight", "ArrowLeft"], ["ArrowUp", "ArrowDown"]] as const) {
      shown = await figure.moves(() => grip.press(there));
      await figure.rest();
      await grip.press(back);
      await figure.rest();
      if (shown) break;
    }
    told.push(`${figure.data.id}: point ${name} moves ${shown ?? "nothing"}`);
  }
  return told;
}

/** Each widget shows something, and what it lets one do changes it. */
async function widgetsWork(figure: Driven): Promise<string[]> {
  const told: string[] = [];
  const widgets = figure.element.locator(".widget");
  expect(await widgets.count(), `${figure.data.id}: widgets`).toBe(figure.data.widgets.length);
  for (const [place, { kind, at }] of figure.data.widgets.entries()) {
    const widget = widgets.nth(place);
    const say = (what: string, shown: string | undefined) => told.push(`${figure.data.id}: ${kind}: ${what} moves ${shown ?? "nothing"}`);
    if (kind === "matrix") {
      const cells = widget.locator(".cell");
      expect([4, 9, 16], `${figure.data.id}: cells`).toContain(await cells.count());
      const field = widget.locator("input.cell").first();
      if ((await field.count()) > 0) {
        say("an entry", await figure.moves(async () => { await field.focus(); await figure.page.keyboard.press("ArrowUp"); }));
      }
      const end = await figure.words();
      await widget.getByRole("button").press("Enter");
      await expect(figure.element).toHaveAttribute("aria-busy", "true");
      await expect(figure.element).not.toHaveAttribute("aria-busy", "true");
      await expect.poll(() => figure.words(), `${figure.data.id}: the way ends where it was`).toBe(end);
    } else if (kind === "colours") {
      await expect(widget.locator(".told")).toContainText("–");
      say("the switch", await figure.moves(() => widget.getByRole("checkbox").press("Space")));
      await widget.getByRole("checkbox").press("Space");
    } else {
      // A hodograph without a parameter is a curve and the origin; all else has more.
      const least = kind === "hodograph" && at.length === 0 ? 2 : 3;
      const drawn = widget.locator("svg").locator("polyline, circle");
      expect(await drawn.count(), `${figure.data.id}: ${kind}`).toBeGreaterThanOrEqual(least);
    }
    if (kind === "knots") {
      const shown = await figure.moves(() => widget.getByRole("radio").last().press("Space"));
      say("the count of the textbooks", shown);
      await widget.getByRole("radio").first().press("Space");
    }
    if (kind === "uv") say("an arrow key", await figure.moves(() => widget.getByRole("group").press("ArrowRight")));
  }
  return told;
}

/** The solution that the page knows is taken as right. */
async function isSolved(section: Locator, values: [string, number | boolean][]): Promise<void> {
  const figureId = await section.evaluate((element) => (JSON.parse(element.querySelector("script")?.textContent ?? "{}") as { figure: string }).figure);
  const figure = section.page().locator(`figure[id="${figureId}"] katydid-figure`);
  for (const [name, value] of values) {
    if (name === "answer") await section.getByRole("textbox").fill(String(value));
    else await figure.evaluate((element, [name, value]) => (element as HTMLElement & { set(name: string, value: number | boolean): Promise<void> }).set(name as string, value!), [name, value] as const);
  }
  await expect(async () => {
    await section.locator(".check button").press("Enter");
    await expect(section.locator(".verdict")).toHaveText(/That is right/, { timeout: 2000 });
  }).toPass();
}

async function stepsGo(steps: Locator): Promise<void> {
  const [, next] = [steps.locator("button").first(), steps.locator("button").last()];
  await next.press("Enter");
  await expect(steps.locator(".step.now")).toHaveCount(1);
  await next.press("Enter");
  await expect(steps.locator(".place")).toContainText("2");
}

/** What reaches beyond the right edge of the window, and is not in something that scrolls. */
async function overflowing(body: Locator): Promise<string[]> {
  return await body.evaluate((body) => {
    const wide = document.documentElement.clientWidth;
    const found: string[] = [];
    const look = (element: Element): void => {
      const style = getComputedStyle(element);
      if (style.display === "none" || style.visibility === "hidden") return;
      const box = element.getBoundingClientRect();
      if (box.width > 0 && box.right > wide + 1) {
        found.push(`${element.tagName.toLowerCase()}.${element.getAttribute("class") ?? ""} to ${Math.round(box.right)}: ${(element.textContent ?? "").slice(0, 40)}`);
        return;
      }
      // What scrolls or is cut off by itself may be wider.
      if (style.overflowX !== "visible") return;
      for (const child of element.children) look(child);
    };
    look(body);
    return found;
  });
}
