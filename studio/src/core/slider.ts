/** The arithmetic of sliders: which numbers there are, where each stands, and what a key or a drag makes of one. */

import type { Control } from "./protocol/Control";
import { evaluate } from "./arithmetic";
import { clamp } from "./geometry";

export type Slider = Extract<Control, { is: "slider" }>;
/** What decides which numbers a slider has. */
export type Scale = Pick<Slider, "min" | "max" | "rounding" | "digits">;

export const MOST_DIGITS = 12;

/** How many places stand after the point. */
export function places({ rounding, digits }: Scale): number {
  return rounding === "float" ? clamp(Math.trunc(digits) || 0, 0, MOST_DIGITS) : 0;
}

/** The distance between neighbours. */
export function step(scale: Scale): number {
  if (scale.rounding === "float") return 10 ** -places(scale);
  return scale.rounding === "integer" ? 1 : 2;
}

/** The nearest number that the slider has. */
export function snapped(scale: Scale, value: number): number {
  const [low, high] = [Math.min(scale.min, scale.max), Math.max(scale.min, scale.max)];
  const wanted = clamp(Number.isFinite(value) ? value : low, low, high);
  if (scale.rounding === "float") return clamp(rounded(wanted, places(scale)), low, high);
  const apart = step(scale);
  const first = scale.rounding === "odd" ? 1 : 0;
  const nearest = apart * Math.round((wanted - first) / apart) + first;
  // The ends need not be among the numbers themselves.
  const inner = nearest < low ? nearest + apart : nearest > high ? nearest - apart : nearest;
  return inner >= low && inner <= high ? inner + 0 : wanted;
}

/** A number rounded to so many places, without the dust of binary fractions. */
export function rounded(value: number, digits: number): number {
  return Math.abs(value) < 1e15 ? Number(value.toFixed(digits)) + 0 : value;
}

/** Where a value stands: 0 at the left end, 1 at the right. */
export function position({ min, max }: Scale, value: number): number {
  const range = max - min;
  const at = range === 0 ? 0.5 : (value - min) / range;
  return Number.isFinite(at) ? clamp(at, 0, 1) : 0.5;
}

/** The number of the slider nearest to a position. */
export function valueAt(scale: Scale, at: number): number {
  return snapped(scale, scale.min + clamp(at, 0, 1) * (scale.max - scale.min));
}

export function sliderText(scale: Scale, value: number): string {
  return Number.isFinite(value) ? value.toFixed(places(scale)) : String(value);
}

/** How many characters the longest number of the slider has: the room to keep for it. */
export function widest(scale: Scale): number {
  return Math.max(sliderText(scale, scale.min).length, sliderText(scale, scale.max).length);
}

/** How a drag goes: plain, ten times finer with Shift, a hundred times with Ctrl. */
export type Fineness = 1 | 0.1 | 0.01;

export function fineness(keys: { shiftKey: boolean; ctrlKey: boolean; metaKey?: boolean }): Fineness {
  return keys.ctrlKey || keys.metaKey ? 0.01 : keys.shiftKey ? 0.1 : 1;
}

/** The value after a key of the ARIA slider pattern; none for other keys. Shift makes arrows go ten steps. */
export function afterKey(scale: Scale, value: number, key: string, shift: boolean): number | undefined {
  const low = Math.min(scale.min, scale.max);
  const high = Math.max(scale.min, scale.max);
  const small = step(scale) * (shift ? 10 : 1);
  const large = Math.max((high - low) / 10, step(scale));
  const by = new Map([
    ["ArrowRight", small],
    ["ArrowUp", small],
    ["ArrowLeft", -small],
    ["ArrowDown", -small],
    ["PageUp", large],
    ["PageDown", -large],
  ]).get(key);
  if (by !== undefined) return snapped(scale, value + by);
  if (key === "Home") return snapped(scale, low);
  return key === "End" ? snapped(scale, high) : undefined;
}

/** The slider after a number was typed: it may lie outside, then the end moves out to it. */
export function typed(slider: Slider, text: string): Slider | undefined {
  const value = evaluate(text.replace(",", "."), slider.value);
  if (value === undefined) return undefined;
  const min = Math.min(slider.min, value);
  const max = Math.max(slider.max, value);
  const wide = { ...slider, min, max };
  return { ...wide, value: snapped(wide, value) };
}

/** Limits about a value as Grasshopper gives a new slider: from 0 to the next power of ten. */
export function limitsAbout(value: number, whole: boolean): [min: number, max: number] {
  const size = Math.abs(value);
  const least = whole ? 10 : 1;
  const end = size <= least ? least : 10 ** Math.ceil(Math.log10(size) - 1e-12);
  return value < 0 ? [-end, 0] : [0, end];
}
