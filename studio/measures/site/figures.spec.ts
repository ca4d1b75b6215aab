/** Figures of the book without a server: how soon the first one lives, and how soon a slider's move is in its picture. */
import { test, type Browser, type Page } from "@playwright/test";

import type { Figure } from "../../src/learn/figure";
import { share } from "../watch";

const PAGES = ["V4", "C3", "S4"];
const STARTS = 5;
const MOVES = 40;

/** Begins the first figure as soon as it can be, and tells how long after the page was asked for its picture was there. */
async function begin(page: Page): Promise<number> {
  const figure = page.locator("katydid-figure").first();
  await figure.getByRole("button").first().click();
  return await page.evaluate(async () => {
    const element = document.querySelector<Figure>("katydid-figure")!;
    for (;;) {
      await new Promise((done) => requestAnimationFrame(done));
      if (Number(element.dataset.solved ?? 0) > 0 && (element.stage?.viewport.frames ?? 0) > 0) break;
    }
    return performance.now();
  });
}

async function starts(browser: Browser, name: string): Promise<{ cold: number[]; warm: number[] }> {
  const [cold, warm]: [number[], number[]] = [[], []];
  for (let k = 0; k < STARTS; k++) {
    // A context of its own has nothing in its cache.
    const context = await browser.newContext({ serviceWorkers: "block" });
    const page = await context.newPage();
    for (const list of [cold, warm]) {
      await page.goto(`/learn/${name}/index.html`);
      list.push(await begin(page));
    }
    await context.close();
  }
  return { cold, warm };
}

/** Moves the first slider step by step, and waits for each picture; the milliseconds from the event to the picture. */
async function moves(page: Page): Promise<{ times: number[]; solves: number[]; draws: number[] }> {
  return await page.evaluate(async (count) => {
    const element = document.querySelector<Figure>("katydid-figure")!;
    const { viewport } = element.stage!;
    const input = element.querySelector<HTMLInputElement>("input[type=range]")!;
    let put = 0;
    let before = 0;
    const note = () => ([put, before] = [performance.now(), viewport.frames]);
    element.lesson!.geometry.listen({ put: note, drop: () => {}, clear: () => {}, failed: () => {} });
    const nextTask = () => new Promise((done) => {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = done;
      port2.postMessage(0);
    });
    const [times, solves, draws]: [number[], number[], number[]] = [[], [], []];
    const [low, high] = [Number(input.min), Number(input.max)];
    for (let k = 0; k < count; k++) {
      await new Promise((done) => setTimeout(done, 60));
      put = 0;
      input.value = String(low + ((high - low) * (k + 1)) / (count + 1));
      const start = performance.now();
      input.dispatchEvent(new Event("input", { bubbles: true }));
      // The first task after the frame that has the picture.
      while ((put === 0 || viewport.frames === before) && performance.now() - start < 3000) {
        await new Promise((done) => requestAnimationFrame(done));
        await nextTask();
      }
      if (put === 0) continue;
      times.push(performance.now() - start);
      solves.push(put - start);
      const alone = performance.now();
      viewport.draw();
      draws.push(performance.now() - alone);
    }
    return { times, solves, draws };
  }, MOVES);
}

for (const name of PAGES) {
  test(`the first figure of ${name}`, async ({ browser, page }) => {
    const { cold, warm } = await starts(browser, name);
    await page.goto(`/learn/${name}/index.html`);
    await begin(page);
    const told = (list: number[]) => `${share(list, 0.5).toFixed(0)} ms (least ${share(list, 0).toFixed(0)}, 95 % ${share(list, 0.95).toFixed(0)})`;
    console.log(`${name}: live after ${told(cold)} cold, ${told(warm)} warm`);
    // Some figures are moved by other controls.
    if ((await page.locator("katydid-figure").first().locator("input[type=range]").count()) === 0) return;
    const { times, solves, draws } = await moves(page);
    console.log(`${name}: slider to picture ${told(times)}, to geometry ${told(solves)}, a picture alone ${told(draws)}, ${times.length} moves`);
  });
}
