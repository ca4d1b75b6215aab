/** A figure on a page, driven by the keyboard alone. */
import { createHash } from "node:crypto";

import { expect, type Locator, type Page } from "@playwright/test";

import type { FigureData } from "../../src/learn/data";
import type { Figure } from "../../src/learn/figure";
import { agrees } from "./book";

export interface Told {
  /** As panels show it. */
  texts: string[];
  /** With all digits. */
  values: unknown[];
}

export class Driven {
  readonly element: Locator;
  data!: FigureData;

  constructor(
    readonly page: Page,
    place: number,
  ) {
    this.element = page.locator("katydid-figure").nth(place);
  }

  /** Starts it as somebody without a mouse does. */
  async start(): Promise<void> {
    this.data = await this.element.evaluate((figure) => (figure as Figure).data);
    const button = this.element.locator("button.start");
    if ((await button.count()) > 0) await button.press("Enter");
    else await this.element.evaluate((figure) => (figure as Figure).start());
    await expect(this.element, "becomes live").toHaveAttribute("data-state", "live");
    await expect(this.element).toHaveAttribute("data-solved", /\d/);
    await expect(button).toHaveCount(0);
  }

  /** What an output gives, by its name in `expected.json`; nothing where there is no such output. */
  outputs(names: string[]): Promise<Record<string, Told | undefined>> {
    return this.element.evaluate(async (element, names) => {
      const figure = element as Figure;
      const lesson = figure.lesson;
      const told: Record<string, Told | undefined> = {};
      for (const name of names) {
        let object = lesson?.named(name);
        let port = 0;
        if (!object) {
          const cut = name.lastIndexOf(".");
          object = lesson?.named(name.slice(0, cut));
          port = object?.outputs.findIndex((one) => one.nickname === name.slice(cut + 1) || one.name === name.slice(cut + 1)) ?? -1;
        }
        const output = object?.outputs[port];
        if (!lesson || !object || !output) continue;
        const answer = await lesson.ask({ ask: "rows", port: output.id, from: 0, count: 500, exact: false, within: [] });
        const rows = answer.event === "rows" ? answer.page.rows : [];
        const texts = rows.flatMap((row) => (row.is === "item" ? [row.text] : []));
        told[name] = { texts, values: await lesson.values(object.id, port) };
      }
      return told;
    }, names);
  }

  /** Compares with `expected.json`; gives how many outputs were compared. */
  async compare(expected: Record<string, unknown[]>): Promise<number> {
    const told = await this.outputs(Object.keys(expected));
    const wrong: string[] = [];
    for (const [name, wanted] of Object.entries(expected)) {
      const found = told[name];
      const isRight =
        found?.values.length === wanted.length &&
        wanted.every((one, at) => (typeof one === "string" ? found.texts[at] === one : agrees(found.values[at], one)));
      if (!isRight) wrong.push(`${name}: ${JSON.stringify(found)}, not ${JSON.stringify(wanted)}`);
    }
    expect.soft(wrong, this.data.id).toEqual([]);
    return Object.keys(expected).length;
  }

  /** All that the page says of the figure in words, and by its widgets. */
  async words(): Promise<string> {
    return await this.element.evaluate((element) => {
      const id = (element as Figure).data.id;
      const spots = [...document.querySelectorAll(`.live[data-figure="${id}"]`)].map((spot) => spot.textContent);
      const widgets = [...element.querySelectorAll(".widget")].map((widget) => widget.innerHTML);
      return [element.querySelector(".say")?.textContent, ...spots, ...widgets].join("\n");
    });
  }

  /** The picture without what lies over it. */
  async picture(): Promise<string> {
    const stage = this.element.locator(".stage");
    if ((await stage.count()) === 0) return "";
    const bytes = await stage.screenshot({ style: ".grip{visibility:hidden}" });
    return createHash("sha256").update(bytes).digest("hex");
  }

  /** Does something that must show; gives what showed it, or nothing where nothing did. */
  async moves(act: () => Promise<void>): Promise<"words" | "picture" | undefined> {
    const [words, picture] = [await this.words(), await this.picture()];
    await act();
    // The words follow a solve, the picture the words: a little patience, and one that shows nothing is told apart.
    for (let wait = 0; wait < 12; wait++) {
      await this.page.waitForTimeout(wait < 4 ? 60 : 250);
      if ((await this.words()) !== words) return "words";
      if (wait > 2 && (await this.picture()) !== picture) return "picture";
    }
    return undefined;
  }

  /** Waits till all that was asked is answered. */
  async rest(): Promise<void> {
    let last = "";
    for (let wait = 0; wait < 40; wait++) {
      await this.page.waitForTimeout(80);
      const now = await this.words();
      if (now === last) return;
      last = now;
    }
  }
}
