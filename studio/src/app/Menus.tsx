import { useEffect, useRef, useState, type KeyboardEvent } from "react";

import { shownKeys } from "../actions/keys";
import { allActions, type Action } from "../actions/registry";
import { t } from "../i18n";

const GROUPS = ["file", "edit", "object", "canvas", "view", "solution", "help"] as const;

/** The menu bar, made of the registry: as the ARIA practices have it, with arrow keys between and within menus. */
export function Menus() {
  const [open, setOpen] = useState<(typeof GROUPS)[number]>();
  const [at, setAt] = useState<(typeof GROUPS)[number]>("file");
  const bar = useRef<HTMLDivElement>(null);
  const groups = GROUPS.filter((group) => allActions().some((action) => action.group === group));

  useEffect(() => {
    if (!open) return;
    const away = (event: PointerEvent) => {
      if (!bar.current?.contains(event.target as Node)) setOpen(undefined);
    };
    addEventListener("pointerdown", away);
    return () => removeEventListener("pointerdown", away);
  }, [open]);

  const head = (group: string) => bar.current?.querySelector<HTMLElement>(`[data-menu="${group}"]`);
  const beside = (group: (typeof GROUPS)[number], step: number) => {
    const next = groups[(groups.indexOf(group) + step + groups.length) % groups.length];
    if (!next) return;
    setAt(next);
    if (open) setOpen(next);
    head(next)?.focus();
  };
  const pressHead = (event: KeyboardEvent, group: (typeof GROUPS)[number]) => {
    if (event.key === "ArrowRight") beside(group, 1);
    else if (event.key === "ArrowLeft") beside(group, -1);
    else if (event.key === "ArrowDown" || event.key === "Enter" || event.key === " ") setOpen(group);
    else if (event.key === "Escape") setOpen(undefined);
    else return;
    event.preventDefault();
  };
  return (
    <div className="menus" role="menubar" aria-label={t("menu.bar")} ref={bar}>
      {groups.map((group) => (
        <div key={group} role="none">
          <button
            type="button"
            role="menuitem"
            aria-haspopup="menu"
            aria-expanded={open === group}
            data-menu={group}
            tabIndex={group === at ? 0 : -1}
            onFocus={() => setAt(group)}
            onClick={() => setOpen(open === group ? undefined : group)}
            onKeyDown={(event) => pressHead(event, group)}
          >
            {t(`group.${group}`)}
          </button>
          {open === group && (
            <Menu
              group={group}
              close={() => {
                setOpen(undefined);
                head(group)?.focus();
              }}
              beside={(step) => beside(group, step)}
            />
          )}
        </div>
      ))}
    </div>
  );
}

interface MenuProps {
  group: Action["group"];
  close(): void;
  beside(step: number): void;
}

function Menu({ group, close, beside }: MenuProps) {
  const list = useRef<HTMLUListElement>(null);
  useEffect(() => list.current?.querySelector<HTMLElement>("[role^=menuitem]")?.focus(), [group]);
  const step = (by: number) => {
    const items = [...(list.current?.querySelectorAll<HTMLElement>("[role^=menuitem]") ?? [])];
    const now = items.indexOf(document.activeElement as HTMLElement);
    items[(now + by + items.length) % items.length]?.focus();
  };
  const press = (event: KeyboardEvent) => {
    if (event.key === "ArrowDown") step(1);
    else if (event.key === "ArrowUp") step(-1);
    else if (event.key === "ArrowRight") beside(1);
    else if (event.key === "ArrowLeft") beside(-1);
    else if (event.key === "Escape" || event.key === "Tab") close();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <ul className="menu" role="menu" aria-label={t(`group.${group}`)} ref={list} onKeyDown={press}>
      {allActions()
        .filter((action) => action.group === group)
        .map((action) => (
          <li key={action.id} role="none">
            <button
              type="button"
              role={action.isOn ? "menuitemcheckbox" : "menuitem"}
              aria-checked={action.isOn?.()}
              aria-disabled={!(action.isEnabled?.() ?? true)}
              tabIndex={-1}
              onClick={() => {
                if (!(action.isEnabled?.() ?? true)) return;
                close();
                void action.run();
              }}
            >
              <span aria-hidden="true" className="tick">
                {action.isOn?.() ? "✓" : ""}
              </span>
              <span>{t(action.label)}</span>
              {action.keys?.[0] && <kbd>{shownKeys(action.keys[0])}</kbd>}
            </button>
          </li>
        ))}
    </ul>
  );
}
