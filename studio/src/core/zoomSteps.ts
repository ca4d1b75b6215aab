/** The zooms that the drop-down offers, from near to far, in percent. Grasshopper's own go from 500 to 12. */
export const ZOOM_STEPS = [500, 400, 300, 200, 150, 100, 75, 50, 25, 12] as const;

/** A zoom in percent, as the drop-down shows it. */
export function percent(zoom: number): number {
  const shown = zoom * 100;
  return shown < 10 ? Math.round(shown * 10) / 10 : Math.round(shown);
}
