/** Several objects wired at once: which grips of the other selected objects go along with one. */

import type { Grip } from "./hit";
import { fit } from "./kinds";
import type { ObjectView } from "./protocol/ObjectView";
import type { PortView } from "./protocol/PortView";

/**
 * The port of another object that goes along with one: the only one that it has on that side; else one of the same name;
 * else that of the same place, where both are of one component. An input must take what the first one takes.
 */
export function alike(of: ObjectView, port: PortView, other: ObjectView, side: "input" | "output"): PortView | undefined {
  const ports = side === "input" ? other.inputs : other.outputs;
  const own = side === "input" ? of.inputs : of.outputs;
  // A floating parameter is named as it likes: its one port is meant.
  const [lone] = ports;
  if (lone && ports.length === 1 && (side === "output" || fit(port.kind, lone.kind) > 0)) return lone;
  const named = ports.find(({ name }) => name === port.name);
  if (named) return named;
  return of.component === other.component ? ports[own.indexOf(port)] : undefined;
}

/** From top to bottom, then from left to right: the order in which an input reads several wires that are drawn at once. */
export function inOrder(grips: readonly Grip[]): Grip[] {
  return [...grips].sort((a, b) => a.at[1] - b.at[1] || a.at[0] - b.at[0]);
}
