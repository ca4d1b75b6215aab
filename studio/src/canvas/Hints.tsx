import { useStore } from "zustand";

import { t } from "../i18n";
import { documentStore } from "../state/document";
import { useCanvas } from "./hooks";

const HINTS = ["canvas.hint.search", "canvas.hint.type", "canvas.hint.drop"] as const;

/** How one begins, on an empty canvas; it goes with the first object, and while something is searched for. */
export function Hints() {
  const isEmpty = useStore(documentStore, (mirror) => mirror.document !== undefined && mirror.objects.size === 0);
  const searching = useCanvas((canvas) => canvas.search !== undefined);
  if (!isEmpty || searching) return null;
  return (
    <ul className="hints">
      {HINTS.map((hint) => (
        <li key={hint}>{t(hint)}</li>
      ))}
    </ul>
  );
}
