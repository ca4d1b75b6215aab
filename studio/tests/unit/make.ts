/** Objects as the session tells of them, for tests. */
import type { ObjectView } from "../../src/core/protocol/ObjectView";
import type { PortView } from "../../src/core/protocol/PortView";

export function port(id: string, sources: string[] = []): PortView {
  return {
    id,
    name: id,
    nickname: id,
    kind: "Number",
    access: "item",
    optional: false,
    at: 10,
    sources,
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
  };
}

export function object(id: string, change: Partial<ObjectView> = {}): ObjectView {
  return {
    id,
    component: "00000000-0000-0000-0000-000000000000",
    kind: "component",
    name: id,
    nickname: id,
    bounds: [0, 0, 60, 40],
    inputs: [],
    outputs: [],
    disabled: false,
    hidden: false,
    previews: false,
    variableInputs: false,
    variableOutputs: false,
    support: { is: "yes" },
    strip: null,
    control: null,
    ...change,
  };
}
