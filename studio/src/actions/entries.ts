/** What stands in a menu of the bar: actions, and menus of actions that belong together. */

import type { Key } from "../i18n";
import { allActions, type Action } from "./registry";

export interface ActionMenu {
  under: Key;
  actions: Action[];
}

export type Entry = Action | ActionMenu;

export function isMenu(entry: Entry): entry is ActionMenu {
  return "actions" in entry;
}

/** The entries of a group, in the order of the registry; a menu stands where the first of its actions would. */
export function entriesOf(group: Action["group"], actions = allActions()): Entry[] {
  const entries: Entry[] = [];
  const menus = new Map<Key, Action[]>();
  for (const action of actions) {
    if (action.group !== group) continue;
    const { under } = action;
    const known = under && menus.get(under);
    if (known) known.push(action);
    else if (under) {
      const list = [action];
      menus.set(under, list);
      entries.push({ under, actions: list });
    } else entries.push(action);
  }
  return entries;
}
