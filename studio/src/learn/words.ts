/** What the page says of itself: its words, and the way to the rest of the book. */

interface PageData {
  words: Record<string, string>;
  /** The way to the root of all languages, and to that of this one. */
  root: string;
  own: string;
  page: string;
}

const element = typeof document === "undefined" ? null : document.getElementById("words");
export const page = JSON.parse(element?.textContent ?? '{"words":{},"root":"./","own":"./","page":""}') as PageData;

/** A word of the interface, with what stands in braces filled in. */
export function word(key: string, fill: Record<string, string | number> = {}): string {
  const text = page.words[key] ?? key;
  return text.replace(/\{(\w+)\}/g, (whole, name: string) => String(fill[name] ?? whole));
}
