/** Finding things by a few letters of their names. */

/** How well a text fits a name, the more the better; undefined when it does not. Case does not matter. */
export function fit(name: string, text: string): number | undefined {
  const n = name.toLowerCase();
  const wanted = text.trim().toLowerCase();
  if (wanted === "") return 0;
  if (n === wanted) return 1000;
  if (n.startsWith(wanted)) return 800 - n.length;
  const words = n.split(/[^\p{L}\p{N}]+/u);
  if (words.some((word) => word.startsWith(wanted))) return 600 - n.length;
  const within = n.indexOf(wanted);
  if (within >= 0) return 400 - within - n.length;
  const initials = words.map((word) => word[0] ?? "").join("");
  if (initials.startsWith(wanted)) return 300 - n.length;
  return inOrder(n, wanted) ? 100 - n.length : undefined;
}

/** Whether the letters of a text stand in a name one after the other, with others between. */
function inOrder(name: string, wanted: string): boolean {
  let from = 0;
  for (const letter of wanted) {
    const at = name.indexOf(letter, from);
    if (at < 0) return false;
    from = at + 1;
  }
  return true;
}

/** Those of a list that fit, the best first; of equals the one that came first. */
export function ranked<T>(list: readonly T[], text: string, name: (of: T) => string): T[] {
  return list
    .map((of, order) => ({ of, order, score: fit(name(of), text) }))
    .filter((entry) => entry.score !== undefined)
    .sort((a, b) => (b.score ?? 0) - (a.score ?? 0) || a.order - b.order)
    .map((entry) => entry.of);
}
