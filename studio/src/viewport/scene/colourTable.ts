/**
 * The colour of everything drawn, in one small texture: what is drawn knows its place in it, so that selecting an
 * object writes four bytes and touches no geometry.
 */

import { DataTexture, NearestFilter, RGBAFormat, UnsignedByteType } from "three";

import type { Rgba } from "../../core/preview";
import { TABLE_WIDTH } from "../shaders/common";

export class ColourTable {
  /** Another texture after growing: shared by all materials as one uniform. */
  readonly uniform: { value: DataTexture };
  /** Another number after each change. */
  version = 0;
  #pixels = new Uint8Array(TABLE_WIDTH * 4);
  #free: number[] = [];
  #used = 0;

  constructor() {
    this.uniform = { value: this.#texture() };
  }

  take(): number {
    const free = this.#free.pop();
    if (free !== undefined) return free;
    const slot = this.#used++;
    if (slot * 4 >= this.#pixels.length) this.#grow();
    return slot;
  }

  give(slot: number): void {
    this.set(slot, [0, 0, 0, 0]);
    this.#free.push(slot);
  }

  set(slot: number, colour: Rgba): void {
    const at = slot * 4;
    if (colour.every((value, channel) => this.#pixels[at + channel] === value)) return;
    this.#pixels.set(colour, at);
    this.version++;
    this.uniform.value.needsUpdate = true;
  }

  get(slot: number): Rgba {
    const [red = 0, green = 0, blue = 0, alpha = 0] = this.#pixels.subarray(slot * 4, slot * 4 + 4);
    return [red, green, blue, alpha];
  }

  dispose(): void {
    this.uniform.value.dispose();
  }

  #grow(): void {
    const pixels = new Uint8Array(this.#pixels.length * 2);
    pixels.set(this.#pixels);
    this.#pixels = pixels;
    this.uniform.value.dispose();
    this.uniform.value = this.#texture();
  }

  #texture(): DataTexture {
    const height = this.#pixels.length / 4 / TABLE_WIDTH;
    const texture = new DataTexture(this.#pixels, TABLE_WIDTH, height, RGBAFormat, UnsignedByteType);
    texture.minFilter = NearestFilter;
    texture.magFilter = NearestFilter;
    texture.needsUpdate = true;
    return texture;
  }
}
