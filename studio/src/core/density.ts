/** How strongly lines are drawn that are close together on the screen. */

/** Of the place that lines take up they cover so much before they fade. */
const FREE = 0.3;
/** They are never fainter. */
const LEAST = 0.18;
/** How wide a line is, in pixels. */
const WIDE = 1.2;

/**
 * For lines of a length all together, within a ball, where a unit is so many pixels. The ball is seen as a disc, and what
 * is behind it shows through: its lines count twice as far apart as on the disc alone.
 */
export function fadeAt(length: number, radius: number, pixels: number): number {
  const area = 2 * Math.PI * (radius * pixels) ** 2;
  const covered = length * pixels * WIDE;
  if (!(covered > 0) || !(area > 0)) return 1;
  return Math.min(Math.max((FREE * area) / covered, LEAST), 1);
}
