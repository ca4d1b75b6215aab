/** What is drawn beside the document's objects goes by ids that no object has. */

import type { Preview } from "../../core/preview";
import type { Viewport } from "../Viewport";

const TOOL = "tool:";
const LAYER = "layer:";

/** Whether it is of a tool: it is not picked, selected or zoomed to. */
export function isTool(id: string): boolean {
  return id.startsWith(TOOL);
}

/** The layer of the Rhino model that it is of, if it is of one. */
export function layerOf(id: string): string | undefined {
  return id.startsWith(LAYER) ? id.slice(LAYER.length) : undefined;
}

/** Whether it is of the document. */
export function isOfDocument(id: string): boolean {
  return !isTool(id) && layerOf(id) === undefined;
}

/** Who draws the analysis of objects. */
export const besides = (viewport: Viewport) => drawnAs(viewport, TOOL, isTool);

/** Who draws the layers of the Rhino model. */
export const layers = (viewport: Viewport) => drawnAs(viewport, LAYER, (id) => layerOf(id) !== undefined);

function drawnAs(viewport: Viewport, prefix: string, isMeant: (id: string) => boolean) {
  return {
    put: (object: string, preview: Preview) => viewport.put(prefix + object, preview),
    drop: (object: string) => viewport.drop(prefix + object),
    clear: () => viewport.clearWhere(isMeant),
  };
}
