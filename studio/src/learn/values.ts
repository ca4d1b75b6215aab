/** Values as they come over the line, and as pages write them: the same as `crates/book/src/value.rs`. */

import type { Row } from "../core/protocol/Row";

export type Value = number | string | boolean | null | number[];

/** A row with all its digits as a value; `isText` where what looks like a number is a text. */
export function parsed(text: string, isText: boolean): Value {
  if (isText) return text;
  const tuple = /^\{(.*)\}$/.exec(text);
  if (tuple) {
    const numbers = (tuple[1] ?? "").split(",").map((part) => Number(part.trim()));
    return numbers.every(Number.isFinite) ? numbers : text;
  }
  if (text === "True" || text === "False") return text === "True";
  if (text === "null" || text === "<null>") return null;
  const number = Number(text);
  return text.trim() !== "" && Number.isFinite(number) ? number : text;
}

export function items(rows: readonly Row[], isText: boolean): Value[] {
  return rows.flatMap((row) => (row.is === "item" ? [parsed(row.text, isText)] : []));
}

/** What of the items is meant: one of them, and of that one coordinate; `undefined` where there is none. */
export function picked(all: readonly Value[], item: number | undefined, axis: number | undefined): Value | Value[] | undefined {
  const found = item === undefined ? (all.length === 1 ? all[0] : [...all]) : all[item];
  if (axis === undefined || found === undefined) return found as Value | Value[] | undefined;
  return Array.isArray(found) ? (found as Value[])[axis] : undefined;
}

const LARGEST_DENOMINATOR = 1000;
const SAME_FRACTION = 1e-10;

function fraction(x: number): [number, number] | undefined {
  let [before, last, rest]: [[number, number], [number, number], number] = [[0, 1], [1, 0], x];
  for (let k = 0; k < 40; k++) {
    const whole = Math.floor(rest);
    const [p, q] = [whole * last[0] + before[0], whole * last[1] + before[1]];
    if (q > LARGEST_DENOMINATOR) return undefined;
    if (Math.abs(p / q - x) <= SAME_FRACTION * Math.max(Math.abs(x), 1)) return [p, q];
    before = last;
    last = [p, q];
    rest = 1 / (rest - whole);
  }
  return undefined;
}

function plain(x: number, digits: number): string {
  const text = x.toFixed(digits);
  const short = text.includes(".") ? text.replace(/0+$/, "").replace(/\.$/, "") : text;
  return short === "-0" ? "0" : short;
}

/** A number with a true minus and without noughts at the end. */
export function number(x: number, style: string): string {
  if (!Number.isFinite(x)) return String(x);
  let text = "";
  if (style === "fraction") {
    const found = fraction(x);
    text = found ? (found[1] === 1 ? String(found[0]) : `${found[0]}/${found[1]}`) : plain(x, 4);
  } else {
    text = plain(x, Number(style));
  }
  return text.replace("-", "−");
}

/** A value in words. */
export function written(value: Value | Value[] | undefined, style: string, isVector: boolean, isList: boolean): string {
  if (value === undefined) return "–";
  if (typeof value === "number") return number(value, style);
  if (Array.isArray(value)) {
    if (isList) return value.map((one) => written(one, style, isVector, false)).join(", ");
    const inner = value.map((one) => written(one, style, false, false)).join(", ");
    return isVector ? `⟨${inner}⟩` : `(${inner})`;
  }
  return String(value);
}

/** Whether two values are as a check wants them: see `crates/book/src/exercise.rs`. */
export function related(left: unknown, relation: string, right: unknown, tolerance: number): boolean {
  if (typeof left === "number" && typeof right === "number") {
    if (relation === "<") return left < right;
    if (relation === ">") return left > right;
    return Math.abs(left - right) <= tolerance;
  }
  if (Array.isArray(left) && Array.isArray(right)) {
    return relation === "=" && left.length === right.length && left.every((one, at) => related(one, relation, right[at], tolerance));
  }
  return relation === "=" && left === right;
}
