import { expect, test } from "vitest";

import type { Rect } from "../../src/core/geometry";
import { spreadSteps } from "../../src/core/spread";

const at = (id: string, x: number, y: number): readonly [string, Rect] => [id, [x - 5, y - 5, 10, 10]];
const all = [at("west", -100, 0), at("east", 100, 0), at("north", 0, -100), at("south", 0, 100)];

test("what lies farther on gives way, along the way that the hand mostly went", () => {
  expect([...spreadSteps(all, [0, 0], [40, 10])]).toEqual([["east", [40, 0]]]);
  expect([...spreadSteps(all, [0, 0], [-40, 10])]).toEqual([["west", [-40, 0]]]);
  expect([...spreadSteps(all, [0, 0], [10, 40])]).toEqual([["south", [0, 40]]]);
  expect([...spreadSteps(all, [-200, 0], [-150, 0])].map(([id]) => id)).toEqual(["west", "east", "north", "south"]);
  expect(spreadSteps(all, [0, 0], [0, 0]).size).toBe(0);
});
