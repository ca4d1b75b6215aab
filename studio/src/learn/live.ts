/** Values and sliders in the text, and symbols tied to what a figure shows. */

import { figureOf, type Figure } from "./figure";
import type { Lesson } from "./lesson";
import { picked, written } from "./values";
import { word } from "./words";

/** Writes the values of a figure wherever the page shows them. */
export async function fillLive(figure: Figure, lesson: Lesson): Promise<void> {
  const spots = document.querySelectorAll<HTMLElement>(`.live[data-figure="${figure.data.id}"]`);
  await Promise.all(
    [...spots].map(async (spot) => {
      const { object = "", output = "0", item, axis, style = "2", vector } = spot.dataset;
      const all = await lesson.values(object, Number(output));
      const value = picked(all, item === undefined ? undefined : Number(item), axis === undefined ? undefined : Number(axis));
      const isList = item === undefined && all.length !== 1;
      const text = written(value, style, vector !== undefined && axis === undefined, isList);
      if (spot.textContent !== text) spot.textContent = text;
    }),
  );
}

const WIDE = 240;

/** Makes the sliders in the text work: dragged sideways, or by arrow keys. */
export function readyDrags(): void {
  for (const spot of document.querySelectorAll<HTMLElement>(".drag")) {
    const { figure: id, name = "", min = "0", max = "1", step = "0.01" } = spot.dataset;
    const [low, high, by] = [Number(min), Number(max), Number(step)];
    spot.tabIndex = 0;
    spot.setAttribute("role", "slider");
    spot.setAttribute("aria-label", name);
    spot.setAttribute("aria-valuemin", min);
    spot.setAttribute("aria-valuemax", max);
    spot.setAttribute("aria-valuenow", (spot.textContent ?? "").replace("−", "-"));
    spot.title = word("drag-hint");
    const put = (value: number) => {
      const near = Math.round((value - low) / by) * by + low;
      void figureOf(id)?.set(name, Math.min(Math.max(Number(near.toFixed(12)), low), high));
    };
    const now = () => Number(spot.getAttribute("aria-valuenow"));
    let from: { x: number; value: number } | undefined;
    spot.addEventListener("pointerdown", (event) => {
      from = { x: event.clientX, value: now() };
      spot.setPointerCapture(event.pointerId);
      event.preventDefault();
      spot.focus();
    });
    spot.addEventListener("pointermove", (event) => {
      if (from) put(from.value + ((event.clientX - from.x) / WIDE) * (high - low));
    });
    const end = () => {
      if (from) figureOf(id)?.ended(name);
      from = undefined;
    };
    spot.addEventListener("pointerup", end);
    spot.addEventListener("pointercancel", end);
    spot.addEventListener("keydown", (event) => {
      const steps: Record<string, number> = { ArrowUp: by, ArrowRight: by, ArrowDown: -by, ArrowLeft: -by, PageUp: 10 * by, PageDown: -10 * by };
      const move = steps[event.key];
      if (event.key === "Home") put(low);
      else if (event.key === "End") put(high);
      else if (move !== undefined) put(now() + move);
      else return;
      event.preventDefault();
    });
  }
}

/** Marks what a symbol stands for while it is pointed at, and all symbols of the same object. */
export function readyTies(): void {
  const mark = (tie: HTMLElement | null, on: boolean) => {
    if (!tie) return;
    const { figure, tie: object } = tie.dataset;
    figureOf(figure)?.hover(on ? object : undefined);
    for (const other of document.querySelectorAll(`[data-tie="${object}"][data-figure="${figure}"]`)) other.classList.toggle("marked", on);
  };
  const tied = (event: Event) => (event.target instanceof Element ? event.target.closest<HTMLElement>("[data-tie]") : null);
  document.addEventListener("pointerover", (event) => mark(tied(event), true));
  document.addEventListener("pointerout", (event) => mark(tied(event), false));
}
