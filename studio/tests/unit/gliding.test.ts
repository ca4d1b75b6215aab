import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { glide, isGliding, whenThereIsTime } from "../../src/canvas/gliding";

let frames: (() => void)[] = [];
/** The next picture is drawn. */
const draw = () => frames.splice(0).forEach((frame) => frame());

beforeEach(() => {
  frames = [];
  vi.useFakeTimers();
  vi.stubGlobal("requestAnimationFrame", (frame: () => void) => frames.push(frame));
});
afterEach(() => {
  vi.advanceTimersByTime(1000);
  while (frames.length > 0) draw();
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

test("a canvas glides for a moment after each push", () => {
  expect(isGliding()).toBe(false);
  glide();
  expect(isGliding()).toBe(true);
  vi.advanceTimersByTime(100);
  glide();
  vi.advanceTimersByTime(100);
  expect(isGliding()).toBe(true);
  vi.advanceTimersByTime(100);
  expect(isGliding()).toBe(false);
});

test("while it glides a few things are done a picture, at rest many, and each once", () => {
  let done = 0;
  const all = Array.from({ length: 40 }, () => whenThereIsTime(() => void (done += 1)));
  glide();
  expect(done).toBe(0);
  draw();
  expect(done).toBeGreaterThan(0);
  expect(done).toBeLessThan(5);
  const gliding = done;
  vi.advanceTimersByTime(1000);
  draw();
  expect(done - gliding).toBeGreaterThan(2 * gliding);
  for (let k = 0; k < 40 && frames.length > 0; k++) draw();
  expect(done).toBe(all.length);
  expect(frames).toHaveLength(0);
});

test("what is forgotten is not done", () => {
  let done = 0;
  const forget = whenThereIsTime(() => void (done += 1));
  whenThereIsTime(() => void (done += 10));
  forget();
  draw();
  expect(done).toBe(10);
});
