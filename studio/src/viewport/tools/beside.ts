/** What is drawn beside the document's objects goes by ids that no object has. */

import type { Preview } from "../../core/preview";
import type { Viewport } from "../Viewport";

const TOOL = "tool:";

/** Whether it is of a tool: it is not picked, selected or zoomed to. */
export function isTool(id: string): boolean {
  return id.startsWith(TOOL);
}

/** Who draws the analysis of objects. */
export function besides(viewport: Viewport) {
  return {
    put: (object: string, preview: Preview) => viewport.put(TOOL + object, preview),
    drop: (object: string) => viewport.drop(TOOL + object),
    clear: () => viewport.clearWhere(isTool),
  };
}
