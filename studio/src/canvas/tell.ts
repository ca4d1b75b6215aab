/** Edits are told to who listens, in the session's own words: what Undo would take back. */

import { documentStore } from "../state/document";
import { lineStore } from "../state/session";
import { mirrored } from "./edits";
import { say } from "./store";

/** Listens until what is given back is called. Values that are set tell themselves: their control has the focus. */
export function tellEdits(): () => void {
  return lineStore.subscribe(({ edited }, before) => {
    if (!edited || edited === before.edited || edited.what === "set") return;
    void mirrored(edited.revision).then(() => {
      const step = documentStore.getState().document?.undo;
      if (step) say(step);
    });
  });
}
