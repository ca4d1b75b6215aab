/** Help on what is selected. */

import { canvasStore } from "../canvas/store";
import { showHelp } from "../dialogs/store";
import { documentStore } from "../state/document";
import { uiStore } from "../state/ui";
import { register } from "./registry";

/** Notes have no component that help would be about. */
const NOTES = new Set(["group", "scribble", "sketch"]);

/** The type of the object that help is wanted on: the one that the keyboard is at, where it is selected, else the first. */
function wanted(): string | undefined {
  const { objects } = documentStore.getState();
  const { selection } = uiStore.getState();
  const { active } = canvasStore.getState();
  const ids = active !== undefined && selection.has(active) ? [active, ...selection] : [...selection];
  for (const id of ids) {
    const object = objects.get(id);
    if (object && !NOTES.has(object.kind)) return object.component;
  }
  return undefined;
}

register({
  id: "help.component",
  label: "help.component",
  keys: ["F1"],
  group: "help",
  isEnabled: () => wanted() !== undefined,
  run() {
    const component = wanted();
    if (component !== undefined) showHelp(component);
  },
});
