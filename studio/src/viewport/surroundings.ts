/** What the document and the canvas say of the objects in the picture. */

import type { Rgba } from "../core/preview";
import { isOfDocument } from "./tools/beside";

export interface Surroundings {
  /** The colours of previews: of objects, and of selected ones. */
  normal: Rgba;
  selected: Rgba;
  selection: ReadonlySet<string>;
  hovered: string | undefined;
  hidden: ReadonlySet<string>;
  /** Where only some are shown: those. */
  only: ReadonlySet<string> | undefined;
  /** The colours of the Rhino model's layers by their ids. */
  layers: ReadonlyMap<string, Rgba>;
  /** Objects that are drawn in a colour of their own in place of `normal`: in a figure of the book. */
  colours?: ReadonlyMap<string, Rgba>;
}

export function isHidden({ hidden, only }: Surroundings, object: string): boolean {
  if (!isOfDocument(object)) return false;
  return hidden.has(object) || (only !== undefined && !only.has(object));
}

/** Whether a picture within one looks like a picture within the other. */
export function areAlike(one: Surroundings, other: Surroundings): boolean {
  return (
    one.hovered === other.hovered &&
    one.layers === other.layers &&
    one.colours === other.colours &&
    areSameColour(one.normal, other.normal) &&
    areSameColour(one.selected, other.selected) &&
    isSameSet(one.selection, other.selection) &&
    isSameSet(one.hidden, other.hidden) &&
    isSameSet(one.only, other.only)
  );
}

function areSameColour(one: Rgba, other: Rgba): boolean {
  return one.every((value, at) => value === other[at]);
}

function isSameSet(one: ReadonlySet<string> | undefined, other: ReadonlySet<string> | undefined): boolean {
  if (one === other) return true;
  if (one?.size !== other?.size || !one || !other) return false;
  for (const id of one) if (!other.has(id)) return false;
  return true;
}
