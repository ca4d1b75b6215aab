import { useId, useMemo, useState, type KeyboardEvent } from "react";

import { shownKeys } from "../actions/keys";
import { allActions } from "../actions/registry";
import { ranked } from "../core/rank";
import { t } from "../i18n";
import { Dialog } from "./Dialog";
import { showDialog } from "./store";

/** Every command by its name: type a few letters, Enter does it. */
export function Palette() {
  const [text, setText] = useState("");
  const [at, setAt] = useState(0);
  const id = useId();
  const found = useMemo(() => {
    const usable = allActions().filter((action) => action.isEnabled?.() ?? true);
    return ranked(usable, text, (action) => t(action.label)).slice(0, 60);
  }, [text]);
  const chosen = Math.min(at, found.length - 1);

  const go = (index: number) => {
    const action = found[index];
    if (!action) return;
    showDialog(undefined);
    // After the dialog has given the focus back, so that the command finds it where it was.
    setTimeout(() => void action.run());
  };
  const press = (event: KeyboardEvent) => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step !== undefined) {
      event.preventDefault();
      setAt((chosen + step + found.length) % Math.max(1, found.length));
    } else if (event.key === "Enter") {
      event.preventDefault();
      go(chosen);
    }
  };
  return (
    <Dialog title={t("palette.title")}>
      <input
        type="search"
        autoFocus
        role="combobox"
        aria-expanded="true"
        aria-controls={`${id}-list`}
        aria-activedescendant={chosen >= 0 ? `${id}-${chosen}` : undefined}
        aria-label={t("palette.label")}
        placeholder={t("palette.label")}
        value={text}
        onChange={(event) => {
          setText(event.target.value);
          setAt(0);
        }}
        onKeyDown={press}
        style={{ width: "100%" }}
      />
      <ul id={`${id}-list`} role="listbox" aria-label={t("palette.title")} className="palette">
        {found.map((action, index) => (
          <li
            key={action.id}
            id={`${id}-${index}`}
            role="option"
            aria-selected={index === chosen}
            onPointerMove={() => setAt(index)}
            onClick={() => go(index)}
            ref={(element) => {
              if (index === chosen) element?.scrollIntoView({ block: "nearest" });
            }}
          >
            <span>{t(action.label)}</span>
            {action.keys?.[0] && <kbd>{shownKeys(action.keys[0])}</kbd>}
          </li>
        ))}
        {found.length === 0 && <li role="presentation">{t("palette.none")}</li>}
      </ul>
    </Dialog>
  );
}
