import { readFileSync, readdirSync } from "node:fs";
import { resolve } from "node:path";

import { describe, expect, it } from "vitest";

import { decodePreview } from "../../src/core/preview";

/** Bytes that the session writes, with what a reader must find in them: crates/session/tests/golden.rs makes both. */
const FOLDER = resolve(import.meta.dirname, "../../../crates/session/tests/golden");
const NAMES = readdirSync(FOLDER).filter((name) => name.endsWith(".preview"));

function bytesOf(name: string): ArrayBuffer {
  const file = readFileSync(resolve(FOLDER, name));
  return file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength) as ArrayBuffer;
}

interface Expected {
  parts: { width: number; pieces: { items?: number }[] }[];
}

const plain = (array: ArrayLike<number> | null) => (array === null ? null : Array.from(array));

function words(bytes: ArrayBuffer) {
  const { object, origin, bounds, draft, parts } = decodePreview(bytes);
  return {
    object,
    origin,
    bounds,
    draft,
    parts: parts.map(({ positions, normals, colours, values, mean, indices, width, ...rest }) => ({
      ...rest,
      width: Math.fround(width),
      positions: plain(positions),
      normals: plain(normals),
      colours: plain(colours),
      values: plain(values),
      mean: plain(mean),
      indices: plain(indices),
    })),
  };
}

describe("bytes that the session writes", () => {
  it("are of all kinds", () => {
    expect(NAMES.length).toBe(8);
  });

  it.each(NAMES)("are read here as there (%s)", (name) => {
    const bytes = bytesOf(name);
    const expected = JSON.parse(readFileSync(resolve(FOLDER, name.replace(".preview", ".json")), "utf8")) as Expected;
    for (const part of expected.parts) {
      // Where nothing is said it is one item.
      for (const piece of part.pieces) piece.items ??= 1;
      part.width = Math.fround(part.width);
    }
    expect(words(bytes)).toEqual(expected);
  });
});
