import { expect, test } from "vitest";

import { pathsOf } from "../../src/canvas/paths";
import type { Page } from "../../src/core/protocol/Page";
import type { Row } from "../../src/core/protocol/Row";

/** A port with branches of these lengths; it counts the questions. */
function port(lengths: readonly number[]) {
  const rows = lengths.flatMap((items, k): Row[] => [
    { is: "path", path: `{0;${k}}`, items },
    ...Array.from({ length: items }, (_, index): Row => ({ is: "item", index, text: "x" })),
  ]);
  const asked: [number, number][] = [];
  const ask = (_: string, from: number, count: number): Promise<Page> => {
    asked.push([from, count]);
    return Promise.resolve({ from, total: rows.length, rows: rows.slice(from, from + count) });
  };
  return { ask, asked };
}

test("all paths are found, whatever lies between them", async () => {
  for (const lengths of [[0], [1, 1, 1], Array.from({ length: 50 }, () => 12), [1000, 3, 5000, 0, 7], [399, 1], [400, 401, 402]]) {
    const { ask } = port(lengths);
    const paths = await pathsOf("p", 100, ask);
    expect(paths.map(({ items }) => items)).toEqual(lengths);
    expect(paths.at(-1)?.path).toBe(`{0;${lengths.length - 1}}`);
  }
});

test("long branches are skipped, not read", async () => {
  const { ask, asked } = port(Array.from({ length: 20 }, () => 10_000));
  expect(await pathsOf("p", 100, ask)).toHaveLength(20);
  expect(asked.reduce((sum, [, count]) => sum + count, 0)).toBeLessThan(500);
});

test("no more than wanted, and an end to the questions", async () => {
  expect(await pathsOf("p", 3, port([1, 1, 1, 1]).ask)).toHaveLength(3);
  const { ask, asked } = port(Array.from({ length: 500 }, () => 1000));
  await pathsOf("p", 400, ask);
  expect(asked.length).toBeLessThanOrEqual(60);
});
