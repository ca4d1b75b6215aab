/** Colours as the protocol has them (red, green, blue, alpha) and as the page writes them. */

export type Rgba = [number, number, number, number];

/** `#rrggbb`, without the alpha. */
export function toHex([r, g, b]: Readonly<Rgba>): string {
  return `#${[r, g, b].map((part) => Math.round(part).toString(16).padStart(2, "0")).join("")}`;
}

/** The colour of `#rrggbb` with an alpha. Anything else is black. */
export function fromHex(text: string, alpha = 255): Rgba {
  const digits = /^#?([0-9a-f]{6})$/i.exec(text)?.[1] ?? "000000";
  const part = (at: number) => Number.parseInt(digits.slice(at, at + 2), 16);
  return [part(0), part(2), part(4), alpha];
}
