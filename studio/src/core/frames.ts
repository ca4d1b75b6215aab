/**
 * Geometry that comes over the socket, each just before the event that names it: a frame is the 16 bytes of its hash, and
 * the geometry.
 */

/** How many bytes of a frame are its hash. */
export const HASH_BYTES = 16;

/** Frames that no event named yet are kept up to so many bytes; geometry of the others is fetched. */
const MOST_BYTES = 64e6;

/** Geometry by its hash. It begins after the hash's bytes. */
export type Frames = ReadonlyMap<string, ArrayBuffer>;

export class FrameBuffer {
  #frames = new Map<string, ArrayBuffer>();
  #size = 0;

  put(frame: ArrayBuffer): void {
    // Shorter ones are no frames: whoever is named by the event is fetched.
    if (frame.byteLength <= HASH_BYTES || this.#size + frame.byteLength > MOST_BYTES) return;
    this.#size += frame.byteLength;
    this.#frames.set(hashOf(frame), frame);
  }

  /** All frames since the last event that names some. */
  take(): Frames {
    const frames = this.#frames;
    this.#frames = new Map();
    this.#size = 0;
    return frames;
  }
}

function hashOf(frame: ArrayBuffer): string {
  return [...new Uint8Array(frame, 0, HASH_BYTES)].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}
