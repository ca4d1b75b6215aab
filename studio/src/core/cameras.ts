/** Cameras that were given a name. */

import { readNamed } from "./named";
import type { Point3 } from "./preview";

/** Where a view looks from, as `Pose` of the viewport has it. */
export interface CameraPose {
  target: Point3;
  height: number;
  azimuth: number;
  elevation: number;
  projection: "perspective" | "parallel";
}

export interface NamedCamera {
  name: string;
  pose: CameraPose;
}

/** The cameras in a text that was kept; what makes no sense in it is left out. */
export function readCameras(text: string | null): NamedCamera[] {
  return readNamed(text, readCamera);
}

function readCamera(value: unknown): NamedCamera | undefined {
  const { name, pose } = fieldsOf(value);
  const { target, height, azimuth, elevation, projection } = fieldsOf(pose);
  if (typeof name !== "string" || name === "") return undefined;
  if (!Array.isArray(target) || target.length !== 3 || !target.every(isNumber)) return undefined;
  if (!isNumber(height) || height <= 0 || !isNumber(azimuth) || !isNumber(elevation)) return undefined;
  if (projection !== "perspective" && projection !== "parallel") return undefined;
  const [x, y, z] = target as unknown as [number, number, number];
  return { name: name.slice(0, 200), pose: { target: [x, y, z], height, azimuth, elevation, projection } };
}

function fieldsOf(value: unknown): Record<string, unknown> {
  return typeof value === "object" && value !== null ? (value as Record<string, unknown>) : {};
}

function isNumber(value: unknown): value is number {
  return typeof value === "number" && Number.isFinite(value);
}
