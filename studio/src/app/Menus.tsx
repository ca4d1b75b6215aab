import { useEffect, useRef, useState, type KeyboardEvent } from "react";

import { entriesOf, isMenu, type Entry } from "../actions/entries";
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
            className="quiet"
            role="menuitem"
            aria-haspopup="menu"
            aria-expanded={open === group}
            data-menu={group}
            tabIndex={group === at ? 0 : -1}
            onFocus={() => setAt(group)}
            // With one menu open, pointing at another opens that.
            onPointerEnter={() => open && setOpen(group)}
            onClick={() => setOpen(open === group ? undefined : group)}
            onKeyDown={(event) => pressHead(event, group)}
          >
            {t(`group.${group}`)}
          </button>
          {open === group && (
            <Menu
              label={t(`group.${group}`)}
              entries={entriesOf(group)}
              close={() => {
                setOpen(undefined);
                head(group)?.focus();
              }}
              right={() => beside(group, 1)}
              left={() => beside(group, -1)}
            />
          )}
        </div>
      ))}
    </div>
  );
}

interface MenuProps {
  label: string;
  entries: readonly Entry[];
  close(): void;
  /** Where the arrows to the right and left lead from an entry that has no menu of its own. */
  right(): void;
  left(): void;
}

function Menu({ label, entries, close, right, left }: MenuProps) {
  const list = useRef<HTMLUListElement>(null);
  const [open, setOpen] = useState<string>();
  useEffect(() => list.current?.querySelector<HTMLElement>("[role^=menuitem]")?.focus(), [label]);
  const items = () => [...(list.current?.querySelectorAll<HTMLElement>(":scope > li > [role^=menuitem]") ?? [])];
  const step = (by: number) => {
    const all = items();
    all[(all.indexOf(document.activeElement as HTMLElement) + by + all.length) % all.length]?.focus();
  };
  const press = (event: KeyboardEvent) => {
    const under = (event.target as HTMLElement).dataset.under;
    if (event.key === "ArrowDown") step(1);
    else if (event.key === "ArrowUp") step(-1);
    else if (event.key === "Home") items()[0]?.focus();
    else if (event.key === "End") items().at(-1)?.focus();
    else if (event.key === "ArrowRight") under ? setOpen(under) : right();
    else if (event.key === "ArrowLeft") left();
    else if (event.key === "Escape" || event.key === "Tab") close();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <ul className="menu" role="menu" aria-label={label} ref={list} onKeyDown={press}>
      {entries.map((entry) =>
        isMenu(entry) ? (
          <li key={entry.under} role="none" className="under" onPointerEnter={() => setOpen(entry.under)}>
            <button
              type="button"
              role="menuitem"
              aria-haspopup="menu"
              aria-expanded={open === entry.under}
              data-under={entry.under}
              tabIndex={-1}
              onClick={() => setOpen(entry.under)}
            >
              <span className="tick" />
              <span>{t(entry.under)}</span>
              <span aria-hidden="true">▸</span>
            </button>
            {open === entry.under && (
              <Menu
                label={t(entry.under)}
                entries={entry.actions}
                close={close}
                right={right}
                left={() => {
                  setOpen(undefined);
                  list.current?.querySelector<HTMLElement>(`[data-under="${entry.under}"]`)?.focus();
                }}
              />
            )}
          </li>
        ) : (
          <li key={entry.id} role="none" onPointerEnter={() => setOpen(undefined)}>
            <Item action={entry} close={close} />
          </li>
        ),
      )}
    </ul>
  );
}

function Item({ action, close }: { action: Action; close(): void }) {
  const isEnabled = action.isEnabled?.() ?? true;
  return (
    <button
      type="button"
      role={action.isOn ? "menuitemcheckbox" : "menuitem"}
      aria-checked={action.isOn?.()}
      aria-disabled={!isEnabled}
      tabIndex={-1}
      onClick={() => {
        if (!isEnabled) return;
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
  );
}
