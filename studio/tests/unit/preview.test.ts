import { describe, expect, it } from "vitest";

import { PreviewError, decodePreview } from "../../src/core/preview";
import { frame, writePreview } from "./previewBytes";

const OBJECT = "0f8fad5b-d9cb-469f-a165-70867728950e";

/** A triangle at (1000, 0, 0), written down byte by byte: nothing of our own code made it. */
function golden(): Uint8Array {
  const head =
    `{"object":"${OBJECT}","origin":[1000.0,0.0,0.0],"bounds":[[1000.0,0.0,0.0],[1001.0,2.0,0.0]],"draft":false,` +
    `"parts":[{"kind":"mesh","colour":null,"width":0.0,"positions":{"type":"f32","offset":0,"count":9},` +
    `"normals":{"type":"i8","offset":40,"count":9},"colours":null,"values":null,"range":null,` +
    `"indices":{"type":"u16","offset":56,"count":3},"texts":[],"textHeight":0.0,` +
    `"pieces":[{"output":0,"path":"{0}","index":0,"start":0,"count":3}]}]}`;
  const text = [...head].map((letter) => letter.charCodeAt(0));
  const blanks = (8 - ((12 + text.length) % 8)) % 8;
  const one = [0x00, 0x00, 0x80, 0x3f];
  const two = [0x00, 0x00, 0x00, 0x40];
  const nought = [0, 0, 0, 0];
  const positions = [nought, nought, nought, one, nought, nought, nought, two, nought].flat();
  return Uint8Array.from([
    0x4b, 0x54, 0x50, 0x56, 2, 0, 0, 0, text.length & 0xff, text.length >> 8, 0, 0,
    ...text,
    ...Array<number>(blanks).fill(0x20),
    ...positions, 0, 0, 0, 0,
    0, 0, 127, 0, 0, 127, 0, 0, 127, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 1, 0, 2, 0, 0, 0,
  ]);
}

describe("a preview", () => {
  it("is read from bytes written by hand, without a copy", () => {
    const bytes = golden();
    const preview = decodePreview(bytes.buffer as ArrayBuffer);
    expect(preview.object).toBe(OBJECT);
    expect(preview.origin).toEqual([1000, 0, 0]);
    expect(preview.bounds).toEqual([[1000, 0, 0], [1001, 2, 0]]);
    const part = preview.parts[0];
    expect(part?.kind).toBe("mesh");
    expect([...(part?.positions ?? [])]).toEqual([0, 0, 0, 1, 0, 0, 0, 2, 0]);
    expect([...(part?.normals ?? [])]).toEqual([0, 0, 127, 0, 0, 127, 0, 0, 127]);
    expect([...(part?.indices ?? [])]).toEqual([0, 1, 2]);
    expect(part?.pieces).toEqual([{ output: 0, path: "{0}", index: 0, start: 0, count: 3, items: 1 }]);
    expect(part?.positions.buffer).toBe(bytes.buffer);
  });

  it("may have empty arrays and no parts", () => {
    expect(decodePreview(writePreview({ object: OBJECT, parts: [] })).parts).toEqual([]);
    const points = writePreview({ object: OBJECT, parts: [{ kind: "points", positions: [1, 2, 3] }] });
    const within = new Uint8Array(points.byteLength + 64);
    within.set(new Uint8Array(points), 16);
    expect([...(decodePreview(within.buffer, 16, points.byteLength).parts[0]?.positions ?? [])]).toEqual([1, 2, 3]);
    expect(() => decodePreview(within.buffer, 16, points.byteLength - 8), "what comes after is not its own").toThrow(PreviewError);
    const empty = decodePreview(writePreview({ object: OBJECT, parts: [{ kind: "curves", positions: [] }] }));
    expect(empty.parts[0]?.positions.length).toBe(0);
  });

  it("has nothing of what its head leaves out", () => {
    const part = { kind: "points", width: 0, positions: { type: "f32", offset: 0, count: 3 }, textHeight: 0 };
    const json = JSON.stringify({ object: OBJECT, origin: [0, 0, 0], draft: false, parts: [part] });
    const read = decodePreview(frame(json, 16, [])).parts[0];
    expect([read?.colour, read?.normals, read?.colours, read?.values, read?.mean, read?.indices]).toEqual(Array(6).fill(null));
    expect([read?.texts, read?.pieces]).toEqual([[], []]);
  });

  it("keeps texts with letters beyond ASCII", () => {
    const parts = [{ kind: "texts", positions: [0, 0, 0], texts: ["höhe 高さ"] }];
    expect(decodePreview(writePreview({ object: OBJECT, parts })).parts[0]?.texts).toEqual(["höhe 高さ"]);
  });

  it("gives parts that share positions the same array", () => {
    const slice = { type: "f32", offset: 0, count: 6 };
    const part = (kind: string) => ({ kind, width: 0, positions: slice, texts: [], textHeight: 0, pieces: [] });
    const json = JSON.stringify({ object: OBJECT, origin: [0, 0, 0], draft: false, parts: [part("edges"), part("points")] });
    const { parts } = decodePreview(frame(json, 24, []));
    expect(parts[0]?.positions).toBe(parts[1]?.positions);
  });

  it("is refused when it is cut off anywhere", () => {
    const bytes = golden();
    // The last two bytes only fill up to a multiple of 8.
    for (let length = 0; length < bytes.length - 2; length++) {
      expect(() => decodePreview(bytes.slice(0, length).buffer), `cut to ${length}`).toThrow(PreviewError);
    }
  });

  it("never throws anything but its own error when a byte is wrong", () => {
    const bytes = golden();
    for (let at = 0; at < bytes.length; at++) {
      for (const flip of [1, 0x10, 0x80, 0xff]) {
        const broken = bytes.slice();
        broken[at] = (broken[at] ?? 0) ^ flip;
        try {
          decodePreview(broken.buffer);
        } catch (error) {
          expect(error).toBeInstanceOf(PreviewError);
        }
      }
    }
  });
});

describe("what is refused", () => {
  const slice = { type: "f32", offset: 0, count: 9 };
  const part = {
    kind: "mesh", colour: null, width: 0, positions: slice, normals: null, colours: null, values: null, range: null,
    indices: null, texts: [], textHeight: 0, pieces: [],
  };
  const head = { object: OBJECT, origin: [0, 0, 0], bounds: null, draft: false, parts: [part] };
  const read = (change: Record<string, unknown>, top: Record<string, unknown> = {}) => {
    const json = JSON.stringify({ ...head, parts: [{ ...part, ...change }], ...top });
    return () => decodePreview(frame(json, 40, [{ offset: 0, array: Float32Array.from({ length: 9 }, (_, i) => i) }]));
  };

  it("is nothing of a good one", () => expect(read({})).not.toThrow());

  it.each([
    ["an offset beyond the end", { positions: { ...slice, offset: 1024 } }],
    ["a count beyond the end", { positions: { ...slice, count: 12 } }],
    ["a count that overflows", { positions: { ...slice, count: 2 ** 31 } }],
    ["a negative offset", { positions: { ...slice, offset: -8 } }],
    ["an offset between", { positions: { ...slice, offset: 4, count: 6 } }],
    ["a half position", { positions: { ...slice, count: 8 } }],
    ["a half triangle", { positions: { ...slice, count: 6 } }],
    ["positions of bytes", { positions: { type: "u8", offset: 0, count: 9 } }],
    ["an unknown type", { positions: { type: "f64", offset: 0, count: 3 } }],
    ["a type from the prototype", { positions: { type: "constructor", offset: 0, count: 3 } }],
    ["a kind that is none", { kind: "voxels" }],
    ["normals of another count", { normals: { type: "f32", offset: 0, count: 6 } }],
    ["values of another count", { values: { type: "f32", offset: 0, count: 2 } }],
    ["colours of another count", { colours: { type: "u8", offset: 0, count: 9 } }],
    ["indices beyond the positions", { indices: { type: "u32", offset: 0, count: 9 } }],
    ["a piece beyond the part", { pieces: [{ output: 0, path: "{0}", index: 0, start: 1, count: 3, items: 1 }] }],
    ["a piece that is no object", { pieces: [7] }],
    ["a colour beyond 255", { colour: [0, 0, 0, 256] }],
    ["a width below nothing", { width: -1 }],
    ["texts without their number", { kind: "texts", texts: ["one"] }],
    ["texts that are none", { texts: [1] }],
  ])("%s", (_, change) => expect(read(change)).toThrow(PreviewError));

  it.each([
    ["an origin without a coordinate", { origin: [0, 0] }],
    ["an origin that is no number", { origin: [0, 0, "1"] }],
    ["bounds the wrong way round", { bounds: [[1, 0, 0], [0, 1, 1]] }],
    ["parts that are no list", { parts: {} }],
    ["too many parts", { parts: Array(5000).fill(part) }],
    ["no object", { object: 7 }],
  ])("%s", (_, top) => expect(read({}, top)).toThrow(PreviewError));

  it("positions that are NaN or infinite", () => {
    for (const bad of [NaN, Infinity, -Infinity]) {
      const parts = [{ kind: "points", positions: [0, bad, 0] }];
      const bytes = writePreview({ object: OBJECT, bounds: null, parts });
      expect(() => decodePreview(bytes)).toThrow(PreviewError);
    }
  });
});
