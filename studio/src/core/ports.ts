/** What a port's name is followed by: signs for what the port does to its data. */

import type { PortView } from "./protocol/PortView";

export type Modifier =
  | "flatten"
  | "graft"
  | "simplify"
  | "reverse"
  | "reparameterize"
  | "unitize"
  | "invert"
  | "degrees"
  | "expression"
  | "principal";

const SIGNS: Record<Modifier, string> = {
  flatten: "↓",
  graft: "↑",
  simplify: "∼",
  reverse: "←",
  reparameterize: "↦",
  unitize: "û",
  invert: "¬",
  degrees: "°",
  expression: "ƒ",
  principal: "★",
};

export function sign(modifier: Modifier): string {
  return SIGNS[modifier];
}

export function modifiers(port: PortView): Modifier[] {
  const all: [boolean, Modifier][] = [
    [port.mapping === "flatten", "flatten"],
    [port.mapping === "graft", "graft"],
    [port.simplify, "simplify"],
    [port.reverse, "reverse"],
    [port.reparameterize, "reparameterize"],
    [port.unitize, "unitize"],
    [port.invert, "invert"],
    [port.degrees, "degrees"],
    [port.expression !== null && port.expression !== "", "expression"],
    [port.principal, "principal"],
  ];
  return all.filter(([on]) => on).map(([, modifier]) => modifier);
}

/** The name that the capsule shows. */
export function portName(port: PortView, full: boolean): string {
  return full ? port.name || port.nickname : port.nickname || port.name;
}
