/**
 * Geometry that comes over the socket just before the event that names it. A frame holds that of several objects, each at
 * a multiple of 8 bytes: the 16 bytes of its hash, its length, four zeros, and the geometry.
 */

/** How many bytes of a frame are a hash, and how many stand before the geometry. */
const HASH_BYTES = 16;
const HEAD_BYTES = HASH_BYTES + 8;
const ALIGNMENT = 8;

/** Frames that no event named yet are kept up to so many bytes; geometry of the others is fetched. */
const MOST_BYTES = 64e6;

/** Geometry by its hash. */
export type Frames = ReadonlyMap<string, Framed>;

/** Geometry within a frame. */
export interface Framed {
  frame: ArrayBuffer;
  start: number;
  length: number;
}

/** Frames up to so many bytes are kept whole as long as something in them is shown: hundreds of copies take longer. */
const KEPT_WHOLE = 1e6;

/** Where geometry is to be read: in its frame, or in a copy that lets a large one go. */
export function placeOf({ frame, start, length }: Framed): [bytes: ArrayBuffer, start: number, length: number] {
  return frame.byteLength <= KEPT_WHOLE ? [frame, start, length] : [frame.slice(start, start + length), 0, length];
}

export class FrameBuffer {
  #frames = new Map<string, Framed>();
  #size = 0;

  put(frame: ArrayBuffer): void {
    if (this.#size + frame.byteLength > MOST_BYTES) return;
    this.#size += frame.byteLength;
    const view = new DataView(frame);
    let at = 0;
    // What is cut off is no geometry: whatever the event names besides is fetched.
    while (at + HEAD_BYTES < frame.byteLength) {
      const start = at + HEAD_BYTES;
      const length = view.getUint32(at + HASH_BYTES, true);
      if (length > frame.byteLength - start) return;
      this.#frames.set(hashOf(view, at), { frame, start, length });
      at = Math.ceil((start + length) / ALIGNMENT) * ALIGNMENT;
    }
  }

  /** All geometry since the last event that names some. */
  take(): Frames {
    const frames = this.#frames;
    this.#frames = new Map();
    this.#size = 0;
    return frames;
  }
}

const digits = Array.from({ length: 256 }, (_, byte) => byte.toString(16).padStart(2, "0"));

function hashOf(view: DataView, at: number): string {
  let hash = "";
  for (let k = 0; k < HASH_BYTES; k++) hash += digits[view.getUint8(at + k)];
  return hash;
}
