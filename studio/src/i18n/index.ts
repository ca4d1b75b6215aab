import { en, type Key } from "./en";

const PLACE = /\{(\w+)(?:\|([^|}]*)\|([^|}]*))?\}/g;

/**
 * The text for a key with its places filled in: `{name}` is a value, `{count|object|objects}` a number with what is
 * counted, of which there may be one.
 */
export function t(key: Key, values: Record<string, string | number> = {}): string {
  return en[key].replace(PLACE, (whole, name: string, one?: string, many?: string) => {
    const value = values[name];
    if (value === undefined) return whole;
    if (one === undefined || many === undefined) return String(value);
    return `${value} ${Number(value) === 1 ? one : many}`;
  });
}

/** The language of the texts, for what the browser writes itself: days and months. */
export const language = "en-GB";

export type { Key };
