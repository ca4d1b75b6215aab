/** Reading JSON that nobody has checked: each field is what it should be, or a `PreviewError`. */

import type { Point3, Rgba } from "./preview";

export class PreviewError extends Error {
  override name = "PreviewError";
}

export class Fields {
  /** What the error calls it. */
  readonly name: string;
  #fields: Record<string, unknown>;

  constructor(value: unknown, name: string) {
    if (typeof value !== "object" || value === null || Array.isArray(value)) {
      throw new PreviewError(`${name} is no object`);
    }
    this.name = name;
    this.#fields = value as Record<string, unknown>;
  }

  isNull(key: string): boolean {
    return (this.#fields[key] ?? null) === null;
  }

  text(key: string): string {
    const value = this.#fields[key];
    return typeof value === "string" ? value : this.#wrong(key, "a text");
  }

  flag(key: string): boolean {
    const value = this.#fields[key];
    return typeof value === "boolean" ? value : this.#wrong(key, "true or false");
  }

  /** A whole number from 0 on. */
  whole(key: string): number {
    const value = this.#fields[key];
    const isWhole = typeof value === "number" && Number.isSafeInteger(value) && value >= 0;
    return isWhole ? value : this.#wrong(key, "a whole number");
  }

  atLeastZero(key: string): number {
    const value = this.#fields[key];
    return typeof value === "number" && value >= 0 && value < Infinity ? value : this.#wrong(key, "a number from 0 on");
  }

  fields(key: string): Fields {
    return new Fields(this.#fields[key], `${key} of ${this.name}`);
  }

  list(key: string, most: number): unknown[] {
    const value = this.#fields[key];
    return Array.isArray(value) && value.length <= most ? value : this.#wrong(key, `a list of at most ${most}`);
  }

  /** A list that may be left out where it is empty. */
  optionalList(key: string, most: number): unknown[] {
    return this.isNull(key) ? [] : this.list(key, most);
  }

  texts(key: string, most: number): string[] {
    const texts = this.optionalList(key, most);
    return texts.every((text) => typeof text === "string") ? texts : this.#wrong(key, "texts");
  }

  numbers(key: string, count: number): number[] {
    const list = this.list(key, count);
    const good = list.length === count && list.every((value) => typeof value === "number" && Number.isFinite(value));
    return good ? (list as number[]) : this.#wrong(key, `${count} numbers`);
  }

  point(key: string): Point3 {
    const [x = 0, y = 0, z = 0] = this.numbers(key, 3);
    return [x, y, z];
  }

  colour(key: string): Rgba | null {
    if (this.isNull(key)) return null;
    const numbers = this.numbers(key, 4);
    if (!numbers.every((value) => Number.isInteger(value) && value >= 0 && value <= 255)) this.#wrong(key, "a colour");
    const [red = 0, green = 0, blue = 0, alpha = 0] = numbers;
    return [red, green, blue, alpha];
  }

  #wrong(key: string, expected: string): never {
    throw new PreviewError(`${key} of ${this.name} is not ${expected}`);
  }
}
