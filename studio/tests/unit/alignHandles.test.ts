import { describe, expect, test } from "vitest";

import { alignHandles, within } from "../../src/core/alignHandles";

describe("the handles about a selection", () => {
  test("stand outside it, each on the side that it is for", () => {
    const handles = new Map(alignHandles([100, 100, 300, 200]).map(({ how, at }) => [how, at]));
    for (const how of ["left", "centre", "right"] as const) expect(handles.get(how)?.[1]).toBeLessThan(100);
    for (const how of ["top", "middle", "bottom"] as const) expect(handles.get(how)?.[0]).toBeLessThan(100);
    expect(handles.get("spreadAcross")?.[1]).toBeGreaterThan(300);
    expect(handles.get("spreadDown")?.[0]).toBeGreaterThan(400);
    expect(handles.get("centre")?.[0]).toBe(250);
    expect(handles.get("left")?.[0]).toBeLessThan(handles.get("right")?.[0] ?? 0);
  });

  test("never cover each other, however small it is", () => {
    for (const [w, h] of [[1, 1], [30, 10], [5, 400], [1000, 700]] as const) {
      const all = alignHandles([0, 0, w, h]);
      all.forEach((a, k) => all.slice(k + 1).forEach((b) => expect(Math.hypot(a.at[0] - b.at[0], a.at[1] - b.at[1])).toBeGreaterThanOrEqual(24)));
    }
  });

  test("come into the window when it is larger than that", () => {
    expect(within([-500, 50, 2000, 100], [800, 600], 40)).toEqual([40, 50, 720, 100]);
    expect(within([900, 0, 50, 50], [800, 600], 40)).toBeUndefined();
  });
});
