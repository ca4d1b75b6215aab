/** How far a grip of the gumball was dragged. */

import { angleAbout, AXES, unit, type Axis, type Grip } from "../../core/gumball";
import { gridSteps, snap } from "../../core/gridSteps";
import type { Point3 } from "../../core/preview";
import type { PlacedPane } from "../panes";
import { dragged, draggedAcross, draggedAlong } from "./rays";

/** What a turn goes by with Shift, and with each press of a key, in degrees. */
export const COARSE = 15;
const LEAST_FACTOR = 0.001;

/** A step of the grid. */
export function stepOf({ pane, height }: PlacedPane): number {
  return gridSteps(pane.rig.pixel(height)).minor;
}

/** The point that the pointer stands for, on what a grip goes along. */
export function reached(grip: Grip, pane: PlacedPane, middle: Point3, [x, y]: readonly [number, number], isUpright: boolean): Point3 | undefined {
  if (grip.axis === undefined) return dragged(pane, middle, x, y, isUpright);
  if (grip.does === "turn") return draggedAcross(pane, middle, unit(grip.axis), x, y);
  return draggedAlong(pane, middle, unit(grip.axis), x, y);
}

interface How {
  isFree: boolean;
  isCoarse: boolean;
  step: number;
}

/** How far a grip was dragged: a length, degrees or a factor. */
export function amountOf(does: Grip["does"], axis: Axis, middle: Point3, from: Point3, to: Point3, { isFree, isCoarse, step }: How): number | undefined {
  const along = (point: Point3) => point[axis] - middle[axis];
  if (does === "move") {
    const length = along(to) - along(from);
    return isFree ? length : snap(length, step);
  }
  if (does === "turn") {
    const degrees = (angleAbout(middle, axis, from, to) * 180) / Math.PI;
    return isCoarse ? snap(degrees, COARSE) : isFree ? degrees : Math.round(degrees);
  }
  if (along(from) === 0) return undefined;
  const factor = Math.max(along(to) / along(from), LEAST_FACTOR);
  return isFree ? factor : Math.max(snap(factor, 0.05), 0.05);
}

/** An amount in words. */
export function said({ does, axis }: Grip, amount: number): string {
  const value = Number(amount.toPrecision(6));
  const name = axis === undefined ? "" : AXES[axis];
  return does === "turn" ? `${name} ${value}°` : does === "scale" ? `${name} × ${value}` : `${name} ${value}`;
}
