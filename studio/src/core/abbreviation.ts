/** Names in few letters, for pictures that have no room for them. */

const MOST = 4;

/** A short name as it is; of a long one the first letters of its words, or its beginning. */
export function abbreviation(name: string): string {
  const plain = name.trim();
  const letters = [...plain];
  if (letters.length <= MOST) return plain;
  const words = plain.split(/[\s|_-]+/).filter((word) => word !== "");
  const first = words.map((word) => [...word][0] ?? "");
  return words.length > 1 ? first.slice(0, MOST).join("").toUpperCase() : letters.slice(0, MOST - 1).join("");
}
