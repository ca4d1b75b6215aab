/** Colours of the document: red, green, blue, alpha, each 0 to 255. */

export type Colour = readonly [number, number, number, number];

export function css([r, g, b, a]: Colour): string {
  return `rgb(${r} ${g} ${b} / ${Math.round((a / 255) * 1000) / 1000})`;
}

/** `#rrggbb`, as colour fields of pages have it. */
export function hex([r, g, b]: Colour): string {
  return `#${[r, g, b].map((part) => Math.round(part).toString(16).padStart(2, "0")).join("")}`;
}

/** The colour of `#rrggbb`; black where it is not that. */
export function fromHex(text: string, alpha = 255): [number, number, number, number] {
  const parts = /^#?([\da-f]{2})([\da-f]{2})([\da-f]{2})$/i.exec(text.trim());
  const [r, g, b] = (parts?.slice(1) ?? []).map((part) => Number.parseInt(part, 16));
  return [r ?? 0, g ?? 0, b ?? 0, alpha];
}

/** Relative luminance, 0 to 1 (WCAG 2.2). */
export function luminance([r, g, b]: Colour): number {
  const linear = (part: number) => {
    const x = part / 255;
    return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  };
  return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
}

/** Whether dark or light text can be read on a colour. */
export function inkOn(colour: Colour): "dark" | "light" {
  return luminance(colour) > 0.179 ? "dark" : "light";
}

/** A gradient as CSS has it; grips may have a sharp change. */
export function gradientCss(grips: readonly { at: number; left: Colour; right: Colour }[]): string {
  const sorted = [...grips].sort((a, b) => a.at - b.at);
  if (sorted.length === 0) return "linear-gradient(90deg, #000, #fff)";
  const stops = sorted.flatMap(({ at, left, right }) => {
    const place = `${Math.round(at * 1000) / 10}%`;
    return [`${css(left)} ${place}`, `${css(right)} ${place}`];
  });
  return `linear-gradient(90deg, ${stops.join(", ")})`;
}
