/** Popup codes: short texts in the search box that place an object with its values. The grammar is Grasshopper's. */

import { limitsAbout, snapped, type Slider } from "./slider";

/** What a code places. */
export type Popup =
  | { is: "panel"; text: string }
  | { is: "scribble"; text: string }
  | { is: "slider"; slider: Slider }
  | { is: "point"; at: [number, number, number] }
  /** A component by its name, with a text for an input: the one of this index. */
  | { is: "operator"; component: string; input: number; value: string | undefined }
  /** Any component by its name, with a value for the first input that takes it. */
  | { is: "initialised"; component: string; value: string };

const NUMBER = String.raw`[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?`;
const ONLY_NUMBER = new RegExp(`^${NUMBER}$`, "i");
const RANGE = new RegExp(`^(${NUMBER})\\s*(<|\\.\\.)\\s*(${NUMBER})?(?:\\s*(?:<|\\.\\.)\\s*(${NUMBER}))?$`, "i");
const POINT = new RegExp(`^[{(]?\\s*(${NUMBER})\\s*,\\s*(${NUMBER})(?:\\s*,\\s*(${NUMBER}))?\\s*[})]?$`, "i");

/** Signs with the component that each names; what follows the sign is its second operand. */
const OPERATORS: readonly (readonly [sign: string, component: string])[] = [
  ["+", "Addition"],
  ["-", "Subtraction"],
  ["*", "Multiplication"],
  ["/", "Division"],
  ["\\", "Integer Division"],
  ["%", "Modulus"],
  ["&", "Concatenate"],
  ["=", "Equality"],
  ["<", "Smaller Than"],
  [">", "Larger Than"],
];

/** Signs that any text may follow. */
const TEXTUAL = "&=<>";

/** What a text in the search box places; none when it is no code but words to search for. */
export function parsePopup(text: string): Popup | undefined {
  if (text.startsWith('"')) return { is: "panel", text: text.slice(1).replace(/"$/, "") };
  if (text.startsWith("//")) return { is: "panel", text: text.slice(2) };
  if (text.startsWith("~")) return { is: "scribble", text: text.slice(1) };
  const code = text.trim();
  return range(code) ?? point(code) ?? pi(code) ?? single(code) ?? operator(code) ?? initialised(code);
}

/** `5<10`, `0<3.5<10`, `1..9`, `0..3..9`, `-7..`. */
function range(code: string): Popup | undefined {
  const match = separated(code);
  if (!match) return undefined;
  const [first, second, third] = match;
  if (first === undefined) return undefined;
  if (second === undefined) return fromOne(first);
  return third === undefined ? fromLimits(first, first, second) : fromLimits(first, second, third);
}

/** The numbers of a range as they were typed. Two dots end a number that could have a point of its own. */
function separated(code: string): (string | undefined)[] | undefined {
  const match = RANGE.exec(code.replace(/\.\.+/g, " .. ").replace(/</g, " < ").trim());
  if (!match) return undefined;
  const [, first, sign, second, third] = match;
  return sign === "<" && second === undefined ? undefined : [first, second, third];
}

/** `7`, `0.50`, and `0-7` for −7: a code that begins with `-` is a subtraction. */
function single(code: string): Popup | undefined {
  const negative = /^0-(\d.*|\.\d.*)$/.exec(code)?.[1];
  if (negative !== undefined && ONLY_NUMBER.test(negative)) return fromOne(`-${negative}`);
  return ONLY_NUMBER.test(code) && !/^[-+]/.test(code) ? fromOne(code) : undefined;
}

function point(code: string): Popup | undefined {
  const match = POINT.exec(code);
  if (!match) return undefined;
  const [x, y, z] = match.slice(1).map((part) => Number(part ?? 0));
  return finite(x, y, z) ? { is: "point", at: [x ?? 0, y ?? 0, z ?? 0] } : undefined;
}

/** `pi`, `2*pi`, `2pi`. */
function pi(code: string): Popup | undefined {
  const match = new RegExp(`^(?:(${NUMBER})\\s*\\*?\\s*)?(?:pi|π)$`, "i").exec(code);
  return match ? { is: "operator", component: "Pi", input: 0, value: match[1] } : undefined;
}

function operator(code: string): Popup | undefined {
  for (const [sign, component] of OPERATORS) {
    if (!code.startsWith(sign)) continue;
    const rest = code.slice(1).trim();
    const fits = rest === "" || TEXTUAL.includes(sign) || ONLY_NUMBER.test(rest);
    return fits ? { is: "operator", component, input: 1, value: rest === "" ? undefined : rest } : undefined;
  }
  return undefined;
}

/** `offset=5`. */
function initialised(code: string): Popup | undefined {
  const match = /^(\p{L}[\p{L}\p{N} .²()-]*?)\s*=\s*(.+)$/u.exec(code);
  const [, component, value] = match ?? [];
  return component === undefined || value === undefined ? undefined : { is: "initialised", component, value };
}

/** How many places a number was typed with; none for a whole one. */
function typedPlaces(text: string): number {
  return /\.(\d*)/.exec(text)?.[1]?.length ?? 0;
}

function fromOne(text: string): Popup | undefined {
  const value = Number(text);
  if (!finite(value)) return undefined;
  const [min, max] = limitsAbout(value, !text.includes("."));
  return slider([text], value, min, max);
}

function fromLimits(low: string, value: string, high: string): Popup | undefined {
  const [a, v, b] = [Number(low), Number(value), Number(high)];
  if (!finite(a, v, b) || a === b) return undefined;
  return slider([low, value, high], v, Math.min(a, b), Math.max(a, b));
}

function slider(as: readonly string[], value: number, min: number, max: number): Popup {
  const digits = Math.min(Math.max(...as.map(typedPlaces)), 12);
  const rounding = as.some((text) => text.includes(".")) ? "float" : "integer";
  const form: Slider = { is: "slider", value, min, max, rounding, digits: Math.max(digits, 1), expression: null };
  return { is: "slider", slider: { ...form, value: snapped(form, value) } };
}

function finite(...numbers: (number | undefined)[]): boolean {
  return numbers.every((x) => x === undefined || Number.isFinite(x));
}
