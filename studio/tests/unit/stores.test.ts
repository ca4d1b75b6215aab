import { expect, test } from "vitest";

import { patched, type DocumentMirror } from "../../src/state/document";
import { withResults, type Run } from "../../src/state/run";
import { object, port } from "./make";

const mirror: DocumentMirror = {
  revision: 1,
  within: [],
  document: undefined,
  objects: new Map([
    ["a", object("a", { outputs: [port("a.out")] })],
    ["b", object("b", { inputs: [port("b.in", ["a.out"])] })],
  ]),
  order: ["a", "b"],
  inputs: new Map(),
  outputs: new Map(),
  restored: null,
  problems: [],
};

test("a patch puts and takes out objects, and their ports are found", () => {
  const after = patched(mirror, {
    event: "patch",
    revision: 2,
    within: [],
    put: [object("c", { inputs: [port("c.in")] })],
    removed: ["a"],
    order: null,
    document: null,
  });
  expect([...after.objects.keys()]).toEqual(["b", "c"]);
  expect(after.order).toEqual(["b", "c"]);
  expect(after.inputs.get("c.in")).toEqual({ object: "c", side: "input", index: 0 });
  expect(after.outputs.size).toBe(0);
  expect(after.objects.get("b")).toBe(mirror.objects.get("b"));
});

test("a patch of another cluster changes nothing that is shown", () => {
  const patch = { event: "patch", revision: 2, within: ["x"], put: [object("c")], removed: [], order: null, document: null } as const;
  const after = patched(mirror, { ...patch, within: ["x"], put: [object("c")], removed: [] });
  expect(after.objects).toBe(mirror.objects);
});

test("results of an older solution are thrown away", () => {
  const run: Run = { results: new Map(), outputs: new Map(), solution: 5, progress: undefined, milliseconds: 0, cancelled: false };
  const event = {
    event: "results" as const,
    within: [],
    results: [
      {
        id: "a",
        status: "ok",
        messages: [],
        milliseconds: 1,
        outputs: [{ port: "a.out", structure: "item" as const, branches: 1, items: 1 }],
        panel: null,
      },
    ],
    finished: true,
    cancelled: false,
    milliseconds: 3,
  };
  expect(withResults(run, { ...event, solution: 4 })).toBe(run);
  const after = withResults(run, { ...event, solution: 6 });
  expect(after.outputs.get("a.out")?.items).toBe(1);
  expect(after.milliseconds).toBe(3);
});
