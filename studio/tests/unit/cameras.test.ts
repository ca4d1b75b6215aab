import { expect, test } from "vitest";

import { readCameras } from "../../src/core/cameras";
import { freshName, renamed, withNamed, without } from "../../src/core/named";

const pose = { target: [1, 2, 3], height: 5, azimuth: 0.5, elevation: 0.25, projection: "perspective" };

test("cameras are kept as they were, and what makes no sense is left out", () => {
  const good = { name: "Entrance", pose };
  const bad = [
    null, 3, {}, { name: "", pose }, { name: "a" }, { name: "b", pose: { ...pose, height: 0 } },
    { name: "c", pose: { ...pose, target: [1, 2] } }, { name: "d", pose: { ...pose, azimuth: "x" } }, { name: "e", pose: { ...pose, projection: "fish" } },
  ];
  expect(readCameras(JSON.stringify([good, ...bad]))).toEqual([good]);
  expect(readCameras("{")).toEqual([]);
  expect(readCameras(null)).toEqual([]);
});

test("a name is there once", () => {
  const list = withNamed(withNamed([], { name: "a", k: 1 }), { name: "b", k: 2 });
  expect(withNamed(list, { name: "a", k: 3 })).toEqual([{ name: "a", k: 3 }, { name: "b", k: 2 }]);
  expect(renamed(list, "a", "b")).toEqual(list);
  expect(renamed(list, "a", " c ").map(({ name }) => name)).toEqual(["c", "b"]);
  expect(without(list, "a")).toEqual([{ name: "b", k: 2 }]);
  expect(freshName([{ name: "1" }, { name: "3" }], String)).toBe("2");
});
