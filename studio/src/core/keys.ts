/** Shortcuts, written as `Mod+Shift+G`: Mod is Ctrl, and Command on a Mac. */

export interface Pressed {
  key: string;
  ctrlKey: boolean;
  metaKey: boolean;
  shiftKey: boolean;
  altKey: boolean;
}

/** Names in shortcuts that are not what the browser calls the key. */
const NAMES: Record<string, string> = {
  left: "arrowleft",
  right: "arrowright",
  up: "arrowup",
  down: "arrowdown",
  esc: "escape",
  del: "delete",
  ins: "insert",
  space: " ",
  plus: "+",
};

/** Whether a key that was pressed is a shortcut. */
export function isPressed(shortcut: string, pressed: Pressed): boolean {
  const parts = shortcut.toLowerCase().split("+");
  const last = parts.pop() ?? "";
  const key = last === "" ? "+" : (NAMES[last] ?? last);
  const mod = parts.includes("mod");
  const shift = parts.includes("shift");
  // Signs such as ? need Shift on some keyboards and not on others.
  const signed = key.length === 1 && !/[a-z0-9 ]/.test(key);
  return (
    pressed.key.toLowerCase() === key &&
    (pressed.ctrlKey || pressed.metaKey) === mod &&
    pressed.altKey === parts.includes("alt") &&
    (signed || pressed.shiftKey === shift)
  );
}
