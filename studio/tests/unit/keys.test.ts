import { describe, expect, test } from "vitest";

import { actionFor, keysOf, shownKeys } from "../../src/actions/keys";
import type { Action } from "../../src/actions/registry";

const pressed = (key: string, held: Partial<Record<"ctrlKey" | "altKey" | "shiftKey" | "metaKey", boolean>> = {}) =>
  ({ key, ctrlKey: false, altKey: false, shiftKey: false, metaKey: false, ...held }) as KeyboardEvent;

describe("keys", () => {
  test("are named with what is held, in one order", () => {
    expect(keysOf(pressed("g", { ctrlKey: true, shiftKey: true }), false)).toBe("Mod+Shift+G");
    expect(keysOf(pressed("g", { metaKey: true }), true)).toBe("Mod+G");
    expect(keysOf(pressed("g", { ctrlKey: true }), true)).toBe("G");
    expect(keysOf(pressed(" "), false)).toBe("Space");
  });

  test("that need Shift on some keyboards are the sign itself", () => {
    expect(keysOf(pressed("?", { shiftKey: true }), false)).toBe("?");
    expect(keysOf(pressed("V", { shiftKey: true }), false)).toBe("Shift+V");
  });

  test("are shown as the system writes them", () => {
    expect(shownKeys("Mod+Shift+G", false)).toBe("Ctrl+Shift+G");
    expect(shownKeys("Mod+Shift+G", true)).toBe("⌘⇧G");
  });

  test("mean what they mean in the place where they are pressed", () => {
    const action = (id: string, scope?: "canvas" | "viewport") =>
      ({ id, keys: ["1"], group: "view", label: "app.title", run: () => undefined, ...(scope ? { scope } : {}) }) as Action;
    const actions = [action("anywhere"), action("there", "viewport")];
    expect(actionFor("1", "viewport", actions)?.id).toBe("there");
    expect(actionFor("1", "canvas", actions)?.id).toBe("anywhere");
    expect(actionFor("1", undefined, [action("there", "viewport")])).toBeUndefined();
    expect(actionFor("2", "viewport", actions)).toBeUndefined();
  });
});
