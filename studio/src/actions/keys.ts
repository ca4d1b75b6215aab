/** Keys as actions name them (`Mod+Shift+G`) and as the keyboard tells them. */

import { allActions, type Action } from "./registry";

export const isMac = typeof navigator !== "undefined" && /Mac|iPhone|iPad/.test(navigator.platform);

/** The name of the key that was pressed, with what was held: in the order Mod, Alt, Shift. */
export function keysOf(event: KeyboardEvent, mac = isMac): string {
  const held = [];
  if (mac ? event.metaKey : event.ctrlKey) held.push("Mod");
  if (event.altKey) held.push("Alt");
  const key = event.key.length === 1 ? event.key.toUpperCase() : event.key;
  // A sign that needs Shift, as `?` does on most keyboards, is that sign and not Shift with it.
  const isSign = event.key.length === 1 && !/[a-z0-9 ]/i.test(event.key);
  if (event.shiftKey && !isSign) held.push("Shift");
  return [...held, key === " " ? "Space" : key].join("+");
}

/** How keys are shown to people. */
export function shownKeys(keys: string, mac = isMac): string {
  const named: Record<string, string> = mac
    ? { Mod: "⌘", Alt: "⌥", Shift: "⇧" }
    : { Mod: "Ctrl", ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓", Escape: "Esc", Delete: "Del" };
  return keys
    .split("+")
    .map((part) => named[part] ?? part)
    .join(mac ? "" : "+");
}

/** Whether somebody is typing: letters are letters there, and not commands. */
export function isTyping(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement) return true;
  return target instanceof HTMLInputElement && !["checkbox", "radio", "range", "button", "color"].includes(target.type);
}

/** Whether a field without text takes these keys itself: radio buttons and ranges go on by arrow keys. */
export function isTaken(target: EventTarget | null, keys: string): boolean {
  const isStepped = target instanceof HTMLInputElement && (target.type === "radio" || target.type === "range");
  return isStepped && /^(Shift\+)?(Arrow(Left|Right|Up|Down)|Home|End|PageUp|PageDown)$/.test(keys);
}

/** The action for some keys in the place where they are pressed; one for that place goes before one for everywhere. */
export function actionFor(keys: string, scope: Action["scope"], actions = allActions()): Action | undefined {
  const fitting = actions.filter((action) => action.keys?.includes(keys));
  return fitting.find((action) => action.scope !== undefined && action.scope === scope) ?? fitting.find((action) => !action.scope);
}

/** Listens to the whole page. Elements that take a key themselves stop it or prevent what it usually does. */
export function followKeys(): () => void {
  const listen = (event: KeyboardEvent) => {
    if (event.defaultPrevented || document.querySelector("dialog[open]")) return;
    const keys = keysOf(event);
    if (isTaken(event.target, keys)) return;
    if (isTyping(event.target) && !keys.startsWith("Mod+")) return;
    // Copying, pasting and undoing inside a text field is the field's own business.
    if (isTyping(event.target) && /^Mod\+(Shift\+)?[ACVXZY]$/.test(keys)) return;
    const holder = event.target instanceof Element ? event.target.closest<HTMLElement>("[data-scope]") : null;
    const action = actionFor(keys, holder?.dataset.scope as Action["scope"]);
    if (!action) return;
    event.preventDefault();
    if (action.isEnabled?.() ?? true) void action.run();
  };
  addEventListener("keydown", listen);
  return () => removeEventListener("keydown", listen);
}
