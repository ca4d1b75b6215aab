/** Numbers as the canvas writes them. */

/** A number with at most six significant places after the point, and no trailing zeros. */
export function numberText(x: number): string {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? "NaN" : x > 0 ? "∞" : "−∞";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e12 || size < 1e-6) return x.toExponential(4).replace(/\.?0+e/, "e");
  return String(Number(x.toFixed(6)));
}

/** A time, in the unit in which it is between 1 and 1000 where there is one. */
export function timeText(milliseconds: number): string {
  if (!(milliseconds >= 0)) return "–";
  if (milliseconds < 1) return milliseconds < 0.05 ? "<0.1 ms" : `${milliseconds.toFixed(1)} ms`;
  if (milliseconds < 1000) return `${milliseconds < 10 ? milliseconds.toFixed(1) : Math.round(milliseconds)} ms`;
  const seconds = milliseconds / 1000;
  return seconds < 60 ? `${seconds.toFixed(1)} s` : `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s`;
}

/** Digits from the left, for a digit scroller: `-012.50` for -12.5 with three before and two after the point. */
export function digitsText(value: number, digits: number, before: number): string {
  const after = Math.max(0, digits - before);
  const [whole, part] = Math.abs(value).toFixed(Math.min(after, 20)).split(".");
  const sign = value < 0 ? "−" : "+";
  return `${sign}${(whole ?? "0").padStart(before, "0")}${part === undefined ? "" : `.${part}`}`;
}
