import { useStore } from "zustand";

import { shownKeys } from "../actions/keys";
import { action } from "../actions/registry";
import { Icon, type IconName } from "../canvas/icons";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { goTo } from "./files";
import { Menus } from "./Menus";
import { settingsStore } from "./settings";

/** The actions with a button of their own; those that everybody knows by their picture show it. */
const BUTTONS: readonly (readonly [id: string, icon?: IconName])[] = [
  ["edit.undo", "undo"],
  ["edit.redo", "redo"],
  ["solution.recompute", "recompute"],
  ["help.palette", "search"],
  ["file.save"],
];

/** The head of the page: the way home, the menus, the document's name, the most used commands. */
export function Header() {
  const view = useStore(documentStore, (mirror) => mirror.document);
  // Labels and states of buttons hang on these.
  useStore(settingsStore);
  return (
    <header className="head">
      <button type="button" className="quiet home" title={t("action.home")} aria-label={t("action.home")} onClick={() => goTo(undefined)}>
        <img src="./icon.svg" alt="" width={20} height={20} />
      </button>
      <Menus />
      {/* The name stands after the menus, with room for the sign of a change: neither moves them. */}
      <h1 title={view?.path ?? undefined}>
        <span className="changed" aria-label={view?.changed ? t("document.changed") : undefined}>
          {view?.changed && "•"}
        </span>
        {view?.name || t("document.unnamed")}
      </h1>
      {BUTTONS.map(([id, icon]) => (
        <Does key={id} id={id} icon={icon} />
      ))}
    </header>
  );
}

function Does({ id, icon }: { id: string; icon: IconName | undefined }) {
  const found = action(id);
  if (!found) return null;
  const label = t(found.label);
  const keys = found.keys?.[0] ? ` (${shownKeys(found.keys[0])})` : "";
  return (
    <button
      type="button"
      className={icon ? "quiet" : undefined}
      title={`${label}${keys}`}
      aria-label={icon && label}
      disabled={!(found.isEnabled?.() ?? true)}
      onClick={() => void found.run()}
    >
      {icon ? <Icon name={icon} size={18} /> : label}
    </button>
  );
}
