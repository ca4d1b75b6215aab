/** How the controls stood when the player was opened, and the way back there. */

import type { Control } from "../core/protocol/Control";
import type { ObjectView } from "../core/protocol/ObjectView";
import type { Setting } from "../core/protocol/Setting";
import { edit, newGesture } from "../state/session";

/** What sets a control to how it stands; undefined for what springs back by itself. */
export function settingOf(control: Control): Setting | undefined {
  switch (control.is) {
    case "slider":
    case "knob":
      return { is: "number", value: control.value };
    case "toggle":
      return { is: "switch", on: control.on };
    case "valueList":
      return { is: "choose", chosen: control.items.flatMap((item, index) => (item.selected ? [index] : [])) };
    case "swatch":
      return { is: "colour", colour: control.colour };
    case "calendar":
      return { is: "date", date: control.date };
    case "clock":
      return { is: "time", seconds: control.seconds };
    case "panel":
      return { is: "text", text: control.text };
    default:
      return undefined;
  }
}

export type Start = ReadonlyMap<string, Setting>;

export function startOf(inputs: readonly ObjectView[]): Start {
  return new Map(
    inputs.flatMap(({ id, control }) => {
      const setting = control && settingOf(control);
      return setting ? [[id, setting] as const] : [];
    }),
  );
}

/** Those that stand elsewhere now. */
export function moved(start: Start, inputs: readonly ObjectView[]): [string, Setting][] {
  const now = startOf(inputs);
  return [...start].filter(([id, setting]) => now.has(id) && JSON.stringify(now.get(id)) !== JSON.stringify(setting));
}

/** Puts all of them back: one step for Undo. */
export function reset(changes: readonly [string, Setting][]): void {
  const gesture = newGesture();
  for (const [object, to] of changes) void edit({ do: "set", object, to }, gesture);
}
