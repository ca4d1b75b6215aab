/**
 * Everything that can be done, once: menus, palette, shortcuts and the sheet of shortcuts read this table.
 * An action is a file in this folder; it is registered where it is defined.
 */

import type { Key } from "../i18n";

export interface Action {
  id: string;
  /** What menus and the palette call it. */
  label: Key;
  /** Keys as `Mod+Shift+G`; Mod is Ctrl, and Command on a Mac. The first is shown. */
  keys?: readonly string[];
  /** Where it belongs in menus and the palette. */
  group: "file" | "edit" | "view" | "object" | "canvas" | "solution" | "help";
  /** The menu within that of its group in which it stands, with others of its kind. */
  under?: Key;
  /** Where its keys work: everywhere, or while the canvas or the viewport has the focus. */
  scope?: "canvas" | "viewport";
  isEnabled?(): boolean;
  /** Whether a switch is on; absent for actions that are none. */
  isOn?(): boolean;
  run(): void | Promise<void>;
}

const actions = new Map<string, Action>();

export function register(...list: Action[]): void {
  for (const action of list) actions.set(action.id, action);
}

export function action(id: string): Action | undefined {
  return actions.get(id);
}

export function allActions(): Action[] {
  return [...actions.values()];
}
