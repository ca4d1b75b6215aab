/**
 * Coordinates as people type them at a command line of Rhino: `3,4` and `3,4,5` on the construction plane, `w3,4,5` in the
 * world, `r3,4` or `@3,4` from the point before, `5<30` as a distance and an angle in degrees, and a number alone as a
 * distance towards the pointer. Each number may be a formula.
 */

import { evaluate } from "./arithmetic";
import { along, distance, minus, pointAt, type Frame } from "./frame";
import type { Point3 } from "./preview";

export interface Typing {
  frame: Frame;
  /** The point before. */
  last: Point3 | undefined;
  /** Where the pointer is. */
  towards: Point3 | undefined;
}

/** The point that was typed; undefined where it is none. */
export function typedPoint(text: string, { frame, last, towards }: Typing): Point3 | undefined {
  const typed = text.trim().toLowerCase();
  const isWorld = typed.startsWith("w");
  const isRelative = typed.startsWith("r") || typed.startsWith("@");
  const rest = isWorld || isRelative ? typed.slice(1) : typed;
  if (isRelative && !last) return undefined;
  const numbers = polar(rest) ?? listed(rest);
  if (!numbers) return undefined;
  if (numbers.length === 1) return isWorld || isRelative ? undefined : ahead(numbers[0] ?? 0, last, towards);
  const [u = 0, v = 0, w = 0] = numbers;
  if (isWorld) return [u, v, w];
  // A distance and an angle count from the point before, where there is one.
  const from = isRelative || (rest.includes("<") && last) ? last : undefined;
  return pointAt(from ? { ...frame, origin: from } : frame, [u, v, w]);
}

function listed(text: string): number[] | undefined {
  const numbers = text.split(",").map((part) => evaluate(part));
  return numbers.length <= 3 && numbers.every((value) => value !== undefined) ? (numbers as number[]) : undefined;
}

function polar(text: string): number[] | undefined {
  const [far, angle, ...more] = text.split("<").map((part) => evaluate(part));
  if (far === undefined || angle === undefined || more.length > 0) return undefined;
  const turn = (angle * Math.PI) / 180;
  return [far * Math.cos(turn), far * Math.sin(turn)];
}

/** So far from the point before towards the pointer. */
function ahead(far: number, last: Point3 | undefined, towards: Point3 | undefined): Point3 | undefined {
  if (!last || !towards) return undefined;
  const size = distance(last, towards);
  return size > 0 ? along(last, [far / size, minus(towards, last)]) : undefined;
}
