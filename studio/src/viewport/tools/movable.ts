/** What the gumball takes: parameters that keep geometry of their own. */

import { SETTABLE } from "../../core/drawing";
import type { ObjectView } from "../../core/protocol/ObjectView";

/** The inputs of those of some objects that are parameters and keep geometry. */
export function movablePorts(objects: readonly (ObjectView | undefined)[]): string[] {
  return objects.flatMap((object) => {
    const port = object?.kind === "parameter" && !object.disabled ? object.inputs[0] : undefined;
    return port && SETTABLE.has(port.kind) && port.sources.length === 0 && port.kept > 0 ? [port.id] : [];
  });
}
