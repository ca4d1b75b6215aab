import { expect, test } from "vitest";

import { outline, title } from "../../src/core/outline";
import { object, port } from "./make";

test("an object comes behind what it reads, and says it", () => {
  const circle = object("circle", { name: "Circle", nickname: "Cir", inputs: [port("R", ["slider"])], outputs: [port("C")] });
  const slider = object("slider", { name: "Number Slider", nickname: "Radius", outputs: [port("slider")] });
  const group = object("group", { kind: "group" });
  const objects = new Map([circle, slider, group].map((one) => [one.id, one]));
  const rows = outline(objects, ["circle", "slider", "group"], new Map());
  expect(rows.map((row) => row.id)).toEqual(["slider", "circle"]);
  expect(rows[1]?.reads).toEqual([{ input: "R", from: ["Radius (Number Slider)"] }]);
  expect(title(circle)).toBe("Cir (Circle)");
});

test("objects in a ring, and chains of ten thousand, are each listed once", () => {
  const ring = [object("a", { inputs: [port("ai", ["bo"])], outputs: [port("ao")] }), object("b", { inputs: [port("bi", ["ao"])], outputs: [port("bo")] })];
  expect(outline(new Map(ring.map((one) => [one.id, one])), ["a", "b"], new Map())).toHaveLength(2);
  const chain = Array.from({ length: 10_000 }, (_, k) =>
    object(`o${k}`, { inputs: [port(`i${k}`, [`p${k + 1}`])], outputs: [port(`p${k}`)] }),
  );
  const rows = outline(new Map(chain.map((one) => [one.id, one])), chain.map((one) => one.id), new Map());
  expect(rows[0]?.id).toBe("o9999");
  expect(rows).toHaveLength(10_000);
});
