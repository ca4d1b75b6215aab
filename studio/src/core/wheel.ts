/** What a wheel or a trackpad means: the browser tells both in the same events. */

/** Grasshopper: the wheel zooms, right-drag pans. Figma: the wheel pans, Ctrl and the wheel zoom, Space-drag pans. */
export type MouseScheme = "grasshopper" | "figma";

export interface Wheel {
  deltaX: number;
  deltaY: number;
  /** 0 pixels, 1 lines, 2 pages. */
  deltaMode: number;
  ctrlKey: boolean;
  metaKey: boolean;
  shiftKey: boolean;
  /** 120 a notch of a wheel, in browsers that have it. */
  wheelDeltaY?: number;
}

export type WheelMeaning = { is: "zoom"; factor: number } | { is: "pan"; by: readonly [number, number] };

const LINE = 16;
const PAGE = 400;

export function wheelMeans(wheel: Wheel, scheme: MouseScheme): WheelMeaning {
  const unit = wheel.deltaMode === 1 ? LINE : wheel.deltaMode === 2 ? PAGE : 1;
  const [dx, dy] = [wheel.deltaX * unit, wheel.deltaY * unit];
  // Browsers tell a pinch as a wheel with Ctrl.
  const pinch = wheel.ctrlKey || wheel.metaKey;
  const zooms = pinch || (scheme === "grasshopper" && !isTrackpad(wheel));
  if (!zooms) return { is: "pan", by: wheel.shiftKey && dx === 0 ? [-dy, 0] : [-dx, -dy] };
  const strength = pinch && Math.abs(dy) < 50 ? 0.01 : 0.0016;
  return { is: "zoom", factor: Math.exp(-Math.max(-240, Math.min(240, dy)) * strength) };
}

/** Two fingers on a trackpad go in small uneven steps, often aside too; a wheel goes in notches. */
function isTrackpad(wheel: Wheel): boolean {
  if (wheel.deltaMode !== 0) return false;
  if (wheel.deltaX !== 0 && !wheel.shiftKey) return true;
  if (wheel.wheelDeltaY !== undefined && wheel.wheelDeltaY !== 0) {
    return Math.abs(wheel.wheelDeltaY) % 120 !== 0 && Math.abs(wheel.deltaY) < 50;
  }
  return Math.abs(wheel.deltaY) < 15;
}
