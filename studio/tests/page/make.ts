/** Objects for documents that tests are made of. */

import type { Control } from "../../src/core/protocol/Control";
import type { ObjectView } from "../../src/core/protocol/ObjectView";
import type { PortView } from "../../src/core/protocol/PortView";

let last = 0;

/** Ids that are the same at every run. */
export function id(): string {
  return `00000000-0000-4000-8000-${String(++last).padStart(12, "0")}`;
}

export function port(name: string, kind: string, at: number, more: Partial<PortView> = {}): PortView {
  return {
    id: id(),
    name,
    nickname: name[0] ?? "",
    kind,
    access: "item",
    optional: false,
    at,
    sources: [],
    wire: "normal",
    mapping: "none",
    reverse: false,
    simplify: false,
    reparameterize: false,
    invert: false,
    degrees: false,
    unitize: false,
    expression: null,
    kept: 0,
    principal: false,
    removable: false,
    ...more,
  };
}

export function object(name: string, bounds: [number, number, number, number], more: Partial<ObjectView> = {}): ObjectView {
  return {
    id: id(),
    component: id(),
    kind: "component",
    name,
    nickname: name,
    bounds,
    inputs: [],
    outputs: [],
    disabled: false,
    hidden: false,
    previews: true,
    variableInputs: false,
    variableOutputs: false,
    support: { is: "yes" },
    strip: null,
    control: null,
    ...more,
  };
}

/** A component with ports, each `Name: Kind`. */
export function component(
  name: string,
  nickname: string,
  [x, y]: [number, number],
  inputs: string[],
  outputs: string[],
  more: Partial<ObjectView> = {},
): ObjectView {
  const rows = Math.max(inputs.length, outputs.length, 1);
  const height = Math.max(rows * 20 + 4, 28);
  const side = (ports: string[]) =>
    ports.map((text, k) => {
      const [own, kind] = text.split(":");
      return port(own ?? "", (kind ?? "Number").trim(), (height * (k + 0.5)) / ports.length);
    });
  return object(name, [x, y, 72, height], { nickname, inputs: side(inputs), outputs: side(outputs), ...more });
}

/** Controls into which no wire can be led. */
const SET_BY_HAND = new Set<Control["is"]>(["slider", "toggle", "button", "valueList", "mdSlider", "knob", "digits", "calendar", "clock", "genes"]);

/** A control with one output. */
export function control(name: string, bounds: [number, number, number, number], control: Control, more: Partial<ObjectView> = {}): ObjectView {
  const made = object(name, bounds, { kind: "control", previews: false, control, ...more });
  const own = port(name, "Number", bounds[3] / 2, { id: made.id });
  return { ...made, inputs: SET_BY_HAND.has(control.is) ? [] : [own], outputs: [own] };
}

export function wire(from: ObjectView, output: number, to: ObjectView, input: number): void {
  const [source, target] = [from.outputs[output], to.inputs[input]];
  if (source && target) target.sources = [...target.sources, source.id];
}
