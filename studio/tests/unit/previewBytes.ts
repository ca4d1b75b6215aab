/** Writes previews for tests, from the words of the layout and not from the reader. */

export interface TestPart {
  kind: string;
  positions: number[] | Float32Array;
  normals?: number[] | Float32Array;
  indices?: number[] | Uint32Array;
  values?: number[] | Float32Array;
  mean?: number[] | Float32Array;
  range?: [number, number];
  colours?: number[];
  colour?: [number, number, number, number];
  width?: number;
  texts?: string[];
  textHeight?: number;
  pieces?: { output: number; path: string; index: number; start: number; count: number }[];
}

export interface TestPreview {
  object: string;
  origin?: [number, number, number];
  bounds?: [[number, number, number], [number, number, number]] | null;
  draft?: boolean;
  parts: TestPart[];
}

type Written = Float32Array | Uint8Array | Uint32Array;

export function writePreview(preview: TestPreview): ArrayBuffer {
  const arrays: { offset: number; array: Written }[] = [];
  let end = 0;
  const put = (type: string, array: Written | undefined) => {
    if (!array) return null;
    const offset = end;
    arrays.push({ offset, array });
    end = Math.ceil((offset + array.byteLength) / 8) * 8;
    return { type, offset, count: array.length };
  };
  const floats = (numbers?: number[] | Float32Array) => (numbers ? Float32Array.from(numbers) : undefined);
  const parts = preview.parts.map((part) => ({
    kind: part.kind,
    colour: part.colour ?? null,
    width: part.width ?? 0,
    positions: put("f32", floats(part.positions)),
    normals: put("f32", floats(part.normals)),
    colours: put("u8", part.colours ? Uint8Array.from(part.colours) : undefined),
    values: put("f32", floats(part.values)),
    range: part.range ?? null,
    mean: put("f32", floats(part.mean)),
    meanRange: null,
    indices: put("u32", part.indices ? Uint32Array.from(part.indices) : undefined),
    texts: part.texts ?? [],
    textHeight: part.textHeight ?? 0,
    pieces: part.pieces ?? [],
  }));
  const origin = preview.origin ?? [0, 0, 0];
  const bounds = preview.bounds === undefined ? boundsOf(preview.parts, origin) : preview.bounds;
  const head = { object: preview.object, origin, bounds, draft: preview.draft ?? false, parts };
  return frame(JSON.stringify(head), end, arrays);
}

/** The frame around a head and arrays. */
export function frame(json: string, size: number, arrays: { offset: number; array: Written }[]): ArrayBuffer {
  const head = new TextEncoder().encode(json);
  const start = Math.ceil((12 + head.length) / 8) * 8;
  const bytes = new ArrayBuffer(start + size);
  const view = new DataView(bytes);
  new Uint8Array(bytes).fill(0x20, 12, start);
  new Uint8Array(bytes, 0, 4).set([0x4b, 0x54, 0x50, 0x56]);
  view.setUint16(4, 2, true);
  view.setUint32(8, head.length, true);
  new Uint8Array(bytes, 12).set(head);
  for (const { offset, array } of arrays) {
    new Uint8Array(bytes, start + offset).set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
  }
  return bytes;
}

function boundsOf(parts: TestPart[], origin: number[]): [[number, number, number], [number, number, number]] | null {
  const least: [number, number, number] = [Infinity, Infinity, Infinity];
  const greatest: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const { positions } of parts) {
    for (let at = 0; at < positions.length; at++) {
      const axis = at % 3;
      const value = (positions[at] ?? 0) + (origin[axis] ?? 0);
      least[axis] = Math.min(least[axis] ?? value, value);
      greatest[axis] = Math.max(greatest[axis] ?? value, value);
    }
  }
  return least[0] <= greatest[0] ? [least, greatest] : null;
}

/** A frame of the socket, and the hash that it says: any name, as 16 bytes. */
export function writeFrame(name: string, preview: ArrayBuffer): { hash: string; frame: ArrayBuffer } {
  const hash = new Uint8Array(16);
  hash.set(new TextEncoder().encode(name).slice(0, 16));
  const bytes = new Uint8Array(24 + Math.ceil(preview.byteLength / 8) * 8);
  bytes.set(hash);
  new DataView(bytes.buffer).setUint32(16, preview.byteLength, true);
  bytes.set(new Uint8Array(preview), 24);
  return { hash: [...hash].map((byte) => byte.toString(16).padStart(2, "0")).join(""), frame: bytes.buffer };
}
