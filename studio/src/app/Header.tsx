import { useStore } from "zustand";

import { shownKeys } from "../actions/keys";
import { action } from "../actions/registry";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { Menus } from "./Menus";
import { settingsStore } from "./settings";

/** The actions with a button of their own. */
const BUTTONS = ["file.save", "edit.undo", "edit.redo", "solution.recompute", "help.palette"];

/** The head of the page: the document's name, the menus, the most used commands. */
export function Header() {
  const view = useStore(documentStore, (mirror) => mirror.document);
  // Labels and states of buttons hang on these.
  useStore(settingsStore);
  return (
    <header className="head">
      <h1 title={view?.path ?? undefined}>
        {view?.changed && <span aria-label={t("document.changed")}>• </span>}
        {view?.name || t("document.unnamed")}
      </h1>
      <Menus />
      <span className="gap" />
      {BUTTONS.map((id) => {
        const found = action(id);
        if (!found) return null;
        const keys = found.keys?.[0] ? ` (${shownKeys(found.keys[0])})` : "";
        return (
          <button
            key={id}
            type="button"
            title={`${t(found.label)}${keys}`}
            disabled={!(found.isEnabled?.() ?? true)}
            onClick={() => void found.run()}
          >
            {t(found.label)}
          </button>
        );
      })}
    </header>
  );
}
