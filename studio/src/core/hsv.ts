/** Hue, saturation and value of colours, and colours that people type. */

import { clamp } from "./geometry";
import { hex, type Colour } from "./colours";

/** Hue in degrees, saturation and value 0 to 1. */
export type Hsv = readonly [hue: number, saturation: number, value: number];

export function toHsv([r, g, b]: Colour): Hsv {
  const most = Math.max(r, g, b);
  const range = most - Math.min(r, g, b);
  if (range === 0) return [0, 0, most / 255];
  const turn = most === r ? (g - b) / range : most === g ? 2 + (b - r) / range : 4 + (r - g) / range;
  return [(turn * 60 + 360) % 360, range / most, most / 255];
}

export function ofHsv([hue, saturation, value]: Hsv, alpha = 255): [number, number, number, number] {
  const part = (shift: number) => {
    const k = (shift + hue / 60) % 6;
    return Math.round(255 * value * (1 - saturation * Math.max(0, Math.min(k, 4 - k, 1))));
  };
  return [part(5), part(3), part(1), alpha];
}

/** A colour as it is shown to be typed over: `#rrggbb`, with the alpha where it is not full. */
export function colourText(colour: Colour): string {
  const alpha = Math.round(colour[3]);
  return alpha === 255 ? hex(colour) : hex(colour) + alpha.toString(16).padStart(2, "0");
}

/** The colour that was typed: `#rgb`, `#rrggbb`, `#rrggbbaa`, or three or four numbers to 255; none where it is none. */
export function readColour(text: string, alpha = 255): [number, number, number, number] | undefined {
  const word = text.trim();
  const digits = /^#?([\da-f]{3}|[\da-f]{6}|[\da-f]{8})$/i.exec(word)?.[1];
  // Three digits without a sign are as likely to be a number that is still being typed.
  if (digits !== undefined && (digits.length > 3 || word.startsWith("#"))) {
    const long = digits.length === 3 ? [...digits].map((digit) => digit + digit).join("") : digits;
    const part = (at: number) => Number.parseInt(long.slice(at, at + 2), 16);
    return [part(0), part(2), part(4), long.length === 8 ? part(6) : alpha];
  }
  const parts = word.split(/[\s,;]+/).map(Number);
  const [r, g, b, a = alpha] = parts;
  if (r === undefined || g === undefined || b === undefined || parts.length > 4) return undefined;
  const all = [r, g, b, a] as const;
  return word !== "" && all.every((part) => part >= 0 && part <= 255) ? [...all] : undefined;
}

/** The colour after a step in the square of saturation (across) and value (up); a step is a hundredth. */
export function steppedHsv([hue, saturation, value]: Hsv, [dx, dy]: readonly [number, number]): Hsv {
  return [hue, clamp(saturation + dx / 100, 0, 1), clamp(value + dy / 100, 0, 1)];
}
