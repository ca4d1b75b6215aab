/** What stands on the ring of commands: other commands when something is selected. */

import { shownKeys } from "../../actions/keys";
import { action } from "../../actions/registry";
import type { Point } from "../../core/geometry";
import { t } from "../../i18n";
import { selection } from "../edits";
import type { IconName } from "../icons";
import { openSearch } from "../open";

export interface RadialItem {
  id: string;
  label: string;
  keys: string;
  icon: IconName;
  on: boolean;
  off: boolean;
  run(): void;
}

type Place = readonly [id: string, icon: IconName];

const OF_GROUND: readonly Place[] = [
  ["canvas.search", "search"],
  ["edit.find", "find"],
  ["view.zoomExtents", "extents"],
  ["solution.recompute", "recompute"],
  ["solution.lock", "lock"],
  ["edit.paste", "paste"],
  ["edit.redo", "redo"],
  ["edit.undo", "undo"],
];

const OF_SELECTION: readonly Place[] = [
  ["object.preview", "preview"],
  ["object.enabled", "enabled"],
  ["object.bake", "bake"],
  ["view.zoomSelected", "selected"],
  ["canvas.group", "group"],
  ["canvas.cluster", "cluster"],
  ["help.component", "help"],
  ["edit.duplicate", "duplicate"],
  ["edit.delete", "remove"],
  ["solution.recompute", "recompute"],
];

/** The commands for a ring about a pixel. What is not registered leaves no gap. */
export function radialItems(pixel: Point): RadialItem[] {
  const places = selection().length > 0 ? OF_SELECTION : OF_GROUND;
  return places.flatMap(([id, icon]) => {
    const found = action(id);
    if (!found) return [];
    return {
      id,
      icon,
      label: t(found.label),
      keys: found.keys?.[0] ? shownKeys(found.keys[0]) : "",
      on: found.isOn?.() ?? false,
      off: found.isEnabled?.() === false,
      // What is searched for goes where the ring was opened.
      run: () => (id === "canvas.search" ? openSearch(pixel) : void found.run()),
    };
  });
}
