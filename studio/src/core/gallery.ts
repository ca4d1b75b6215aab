/** How frames fill a rectangle. */

/** Columns and rows for so many frames in a rectangle, so that they are about square. */
export function gridFor(count: number, [width, height]: readonly [number, number]): [columns: number, rows: number] {
  if (count < 1) return [1, 1];
  const columns = Math.min(Math.max(Math.ceil(Math.sqrt((count * width) / Math.max(height, 1))), 1), count);
  return [columns, Math.ceil(count / columns)];
}
