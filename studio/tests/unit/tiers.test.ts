import { existsSync, readFileSync } from "node:fs";

import { describe, expect, test } from "vitest";

const ROOT = new URL("../../../", import.meta.url);
const rows = readFileSync(new URL("docs/canvas-tiers.md", ROOT), "utf8")
  .split("\n")
  .flatMap((line) => {
    const [, number = "", tier = "", , held = ""] = line.split(/(?<!\\)\|/).map((cell) => cell.trim());
    return /^\d+\.\d+$/.test(number) ? [{ number, tier, held }] : [];
  });

describe("the table of what hands expect", () => {
  test("has all that is missed within five minutes, and all of a first release", () => {
    expect(rows.filter(({ tier }) => tier === "T")).toHaveLength(49);
    expect(rows.filter(({ tier }) => tier === "S").length).toBeGreaterThanOrEqual(27);
    expect(rows.filter(({ tier, held }) => tier !== "L" && !held.startsWith("`"))).toEqual([]);
  });

  test.each(rows.filter(({ held }) => held.startsWith("`")))("$number ($tier): $held", ({ held }) => {
    const [, path = "", title = ""] = /^`([^`]+)` ?(.*)$/.exec(held) ?? [];
    const file = new URL(path.startsWith("crates/") ? path : `studio/${path}`, ROOT);
    expect(existsSync(file), path).toBe(true);
    expect(readFileSync(file, "utf8").includes(title), title).toBe(true);
  });
});
