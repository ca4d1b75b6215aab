import { expect, test } from "vitest";

import { fit, ranked } from "../../src/core/rank";

test("the name itself goes first, then what begins with it, then what has it", () => {
  const names = ["Unlock", "Lock the solver", "Lock", "Clock"];
  expect(ranked(names, "lock", (name) => name)).toEqual(["Lock", "Lock the solver", "Clock", "Unlock"]);
});

test("initials and letters in order are found, others are not", () => {
  expect(fit("Document settings", "ds")).toBeDefined();
  expect(fit("Recompute", "rcm")).toBeDefined();
  expect(fit("Recompute", "xyz")).toBeUndefined();
});

test("without a text everything stays in its order", () => {
  expect(ranked(["b", "a"], "  ", (name) => name)).toEqual(["b", "a"]);
});
