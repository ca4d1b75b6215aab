/** Plays sliders from one state to another, once. Who wants no motion sees the two states. */

import type { Figure } from "../figure";

export interface Way {
  name: string;
  from: number;
  to: number;
  digits: number;
}

/** How long it takes, and how long the first state stands alone, in milliseconds. */
const WHOLE = 1600;
const STAND = 900;

const pause = (milliseconds: number) => new Promise((done) => setTimeout(done, milliseconds));
const frame = () => new Promise<number>((done) => requestAnimationFrame(done));

/** Slow at both ends. */
const eased = (share: number): number => share * share * (3 - 2 * share);

const isPlaying = new WeakSet<Figure>();

export async function play(figure: Figure, ways: readonly Way[]): Promise<void> {
  if (ways.length === 0 || isPlaying.has(figure)) return;
  isPlaying.add(figure);
  // What is read aloud is how it ends.
  figure.setAttribute("aria-busy", "true");
  const show = (share: number) =>
    Promise.all(ways.map(({ name, from, to, digits }) => figure.set(name, share < 1 ? Number((from + (to - from) * share).toFixed(digits)) : to)));
  try {
    await show(0);
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      await pause(STAND);
    } else {
      await pause(STAND / 3);
      const start = performance.now();
      for (let share = 0; share < 1; share = Math.min((performance.now() - start) / WHOLE, 1)) {
        await show(eased(share));
        await frame();
      }
    }
    await show(1);
  } finally {
    for (const { name } of ways) figure.ended(name);
    figure.removeAttribute("aria-busy");
    isPlaying.delete(figure);
  }
}
