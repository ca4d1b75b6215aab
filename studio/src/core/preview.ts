/**
 * Reads previews: the geometry of one object as crates/session/src/protocol/preview.rs lays it out.
 * Arrays become views of the bytes, without a copy; every view is checked against the bytes before it is made, and
 * every index against what it points into, so that whatever draws or picks may trust them.
 */

import type { PartKind } from "./protocol/PartKind";
import type { Piece } from "./protocol/Piece";
import { Fields, PreviewError } from "./previewFields";

export { PreviewError } from "./previewFields";

/** `KTPV`, little-endian. */
export const PREVIEW_MAGIC = 0x5650544b;
export const PREVIEW_VERSION = 2;

const FIXED = 12;
const ALIGNMENT = 8;
const MOST_PARTS = 4096;
const UTF8 = new TextDecoder("utf-8", { fatal: true });

export type Point3 = readonly [number, number, number];
export type Rgba = readonly [number, number, number, number];
/** The least and the greatest coordinates, in double precision. */
export type Bounds = readonly [Point3, Point3];

/** Things of one kind and one look. */
export interface PreviewPart {
  kind: PartKind;
  colour: Rgba | null;
  width: number;
  /** Offsets from the preview's origin, three numbers each. */
  positions: Float32Array;
  normals: Float32Array | Int8Array | null;
  colours: Uint8Array | null;
  /** The Gaussian curvature at each position, and the mean curvature. */
  values: Float32Array | null;
  mean: Float32Array | null;
  indices: Uint16Array | Uint32Array | null;
  texts: string[];
  textHeight: number;
  pieces: Piece[];
}

export interface Preview {
  object: string;
  origin: Point3;
  bounds: Bounds | null;
  draft: boolean;
  parts: PreviewPart[];
  /** How many bytes it came in. */
  size: number;
}

const KINDS: ReadonlySet<string> = new Set<PartKind>([
  "mesh", "edges", "isocurves", "curves", "arrows", "points", "controlPoints", "hull", "comb", "circles", "planes", "texts",
]);

/** How many positions belong together, where there is more than one. */
function corners(kind: PartKind): number {
  if (kind === "mesh") return 3;
  return kind === "points" || kind === "controlPoints" || kind === "texts" ? 1 : 2;
}

/**
 * Reads a preview, which may be a part of the bytes that begins at a multiple of 8, or throws a `PreviewError` that says
 * what is wrong with it.
 */
export function decodePreview(bytes: ArrayBuffer, at = 0, size = bytes.byteLength - at): Preview {
  if (size < FIXED) throw new PreviewError("shorter than its own beginning");
  const view = new DataView(bytes, at, size);
  if (view.getUint32(0, true) !== PREVIEW_MAGIC) throw new PreviewError("not a preview");
  const version = view.getUint16(4, true);
  if (version !== PREVIEW_VERSION) throw new PreviewError(`of version ${version}, not ${PREVIEW_VERSION}`);
  const length = view.getUint32(8, true);
  if (length > view.byteLength - FIXED) throw new PreviewError("shorter than its head says");
  const start = Math.ceil((FIXED + length) / ALIGNMENT) * ALIGNMENT;
  const head = new Fields(readHead(new Uint8Array(bytes, at + FIXED, length)), "head");
  const arrays = new Arrays(bytes, at + Math.min(start, size), at + size);
  return {
    object: head.text("object"),
    origin: head.point("origin"),
    bounds: readBounds(head),
    draft: head.flag("draft"),
    parts: head.list("parts", MOST_PARTS).map((part, index) => readPart(new Fields(part, `part ${index}`), arrays)),
    size: view.byteLength,
  };
}

function readHead(head: Uint8Array): unknown {
  try {
    return JSON.parse(UTF8.decode(head));
  } catch {
    throw new PreviewError("its head is no JSON");
  }
}

function readBounds(head: Fields): Bounds | null {
  if (head.isNull("bounds")) return null;
  const both = head.list("bounds", 2);
  if (both.length !== 2) throw new PreviewError("bounds are two points");
  const pair = new Fields({ least: both[0], greatest: both[1] }, "bounds");
  const least = pair.point("least");
  const greatest = pair.point("greatest");
  if (least.some((value, axis) => value > (greatest[axis] ?? value))) {
    throw new PreviewError("bounds are the wrong way round");
  }
  return [least, greatest];
}

function readPart(part: Fields, arrays: Arrays): PreviewPart {
  const kind = part.text("kind") as PartKind;
  if (!KINDS.has(kind)) throw new PreviewError(`${part.name} is of no known kind`);
  const positions = arrays.read(part, "positions", ["f32"]) as Float32Array;
  if (positions.length % 3 !== 0) throw new PreviewError(`${part.name} has a broken position`);
  if (!arrays.isFinite(positions)) throw new PreviewError(`${part.name} has positions that are no numbers`);
  const count = positions.length / 3;
  const normals = arrays.readOptional(part, "normals", ["f32", "i8"], positions.length);
  const colours = arrays.readOptional(part, "colours", ["u8"], count * 4);
  const values = arrays.readOptional(part, "values", ["f32"], count);
  const mean = arrays.readOptional(part, "mean", ["f32"], count);
  const indices = arrays.readOptional(part, "indices", ["u16", "u32"]);
  if (indices) checkIndices(indices as Uint16Array | Uint32Array, count, part.name);
  const used = indices ? indices.length : count;
  if (used % corners(kind) !== 0) throw new PreviewError(`${part.name} ends in the middle of something`);
  const texts = part.texts("texts", count);
  if (kind === "texts" && texts.length !== count) throw new PreviewError(`${part.name} has not one text a position`);
  return {
    kind,
    colour: part.colour("colour"),
    width: part.atLeastZero("width"),
    positions,
    normals: normals as Float32Array | Int8Array | null,
    colours: colours as Uint8Array | null,
    values: values as Float32Array | null,
    mean: mean as Float32Array | null,
    indices: indices as Uint16Array | Uint32Array | null,
    texts,
    textHeight: part.atLeastZero("textHeight"),
    pieces: readPieces(part, used),
  };
}

function readPieces(part: Fields, used: number): Piece[] {
  return part.optionalList("pieces", Infinity).map((entry) => {
    const piece = new Fields(entry, `a piece of ${part.name}`);
    const [output, index] = [piece.whole("output"), piece.whole("index")];
    const [start, count] = [piece.whole("start"), piece.whole("count")];
    const items = piece.isNull("items") ? 1 : piece.whole("items");
    if (start + count * items > used) throw new PreviewError(`${piece.name} goes beyond its part`);
    return { output, path: piece.text("path"), index, start, count, items };
  });
}

/** Whether all are finite: infinity and NaN times 0 are NaN, and NaN stays. */
function isFinite(numbers: Float32Array): boolean {
  let sum = 0;
  for (let at = 0; at < numbers.length; at++) sum += (numbers[at] ?? 0) * 0;
  return sum === 0;
}

function checkIndices(indices: Uint16Array | Uint32Array, count: number, name: string): void {
  let greatest = -1;
  for (let at = 0; at < indices.length; at++) {
    const index = indices[at] ?? 0;
    if (index > greatest) greatest = index;
  }
  if (greatest >= count) throw new PreviewError(`${name} points at position ${greatest} of ${count}`);
}

type AnyArray = Float32Array | Int8Array | Uint8Array | Uint16Array | Uint32Array;

const MAKERS = {
  f32: Float32Array,
  i8: Int8Array,
  u8: Uint8Array,
  u16: Uint16Array,
  u32: Uint32Array,
} as const;

type ArrayType = keyof typeof MAKERS;

/** The arrays behind the head. */
class Arrays {
  #bytes: ArrayBuffer;
  #start: number;
  #end: number;
  /** The views made so far: parts that share positions get the same view, which is looked through once. */
  #views = new Map<string, AnyArray>();
  #finite = new Set<Float32Array>();

  constructor(bytes: ArrayBuffer, start: number, end: number) {
    this.#bytes = bytes;
    this.#start = start;
    this.#end = end;
  }

  readOptional(part: Fields, name: string, types: readonly ArrayType[], count?: number): AnyArray | null {
    if (part.isNull(name)) return null;
    const array = this.read(part, name, types);
    if (count !== undefined && array.length !== count) {
      throw new PreviewError(`${part.name} has ${array.length} numbers of ${name}, not ${count}`);
    }
    return array;
  }

  read(part: Fields, name: string, types: readonly ArrayType[]): AnyArray {
    const slice = part.fields(name);
    const type = slice.text("type") as ArrayType;
    if (!types.includes(type)) throw new PreviewError(`${name} of ${part.name} cannot be of type ${type}`);
    const [offset, count] = [slice.whole("offset"), slice.whole("count")];
    const Maker = MAKERS[type];
    if (offset % ALIGNMENT !== 0) throw new PreviewError(`${name} of ${part.name} is not aligned`);
    if (this.#start + offset + count * Maker.BYTES_PER_ELEMENT > this.#end) {
      throw new PreviewError(`${name} of ${part.name} goes beyond the end`);
    }
    const key = `${type} ${offset} ${count}`;
    const view = this.#views.get(key) ?? new Maker(this.#bytes, count === 0 ? 0 : this.#start + offset, count);
    this.#views.set(key, view);
    return view;
  }

  isFinite(numbers: Float32Array): boolean {
    if (this.#finite.has(numbers)) return true;
    const good = isFinite(numbers);
    if (good) this.#finite.add(numbers);
    return good;
  }
}
