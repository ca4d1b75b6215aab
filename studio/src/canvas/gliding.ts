/**
 * While a hand moves the canvas each frame has little time. What comes into sight is drawn plainly then, and with all its
 * parts a few objects a frame later.
 */

/** The canvas rests when it has not been moved for so long, in milliseconds. */
const REST = 120;
/** How many objects get their parts in a frame, while the canvas is moved and when it rests. */
const FEW = 2;
const MANY = 16;

let movedAt = -Infinity;
let frame: number | undefined;
const waiting = new Set<() => void>();

/** The canvas was moved by a hand. */
export function glide(): void {
  movedAt = performance.now();
}

export function isGliding(now = performance.now()): boolean {
  return now - movedAt < REST;
}

/** Does something when there is time for it; gives how to forget it. */
export function whenThereIsTime(act: () => void): () => void {
  waiting.add(act);
  frame ??= requestAnimationFrame(next);
  return () => waiting.delete(act);
}

function next(): void {
  let left = isGliding() ? FEW : MANY;
  for (const act of waiting) {
    if (left === 0) break;
    left -= 1;
    waiting.delete(act);
    act();
  }
  frame = waiting.size > 0 ? requestAnimationFrame(next) : undefined;
}
