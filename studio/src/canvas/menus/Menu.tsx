import { useEffect, useLayoutEffect, useRef, useState, type KeyboardEvent } from "react";

import type { Point } from "../../core/geometry";
import { paneSize } from "../view";
import type { Item } from "./items";

interface MenuProps {
  items: readonly Item[];
  pixel: Point;
  /** Whether it opens upwards. */
  above?: boolean;
  label: string;
  /** Something was chosen, or all menus are to be closed. */
  onClose(): void;
  /** Back to the menu that this one opened from. */
  onBack?(): void;
}

/** A menu: arrows go through it, Enter chooses, the left arrow and Escape go back. */
export function Menu({ items, pixel, above = false, label, onClose, onBack }: MenuProps) {
  const beside = onBack !== undefined;
  const box = useRef<HTMLDivElement>(null);
  const [place, setPlace] = useState<Point>(pixel);
  const [open, setOpen] = useState<number | undefined>(undefined);

  // It is moved so that all of it can be seen.
  useLayoutEffect(() => {
    const element = box.current;
    if (!element || beside) return;
    const [width, height] = paneSize();
    const fit = (at: number, size: number, room: number) => Math.max(Math.min(at, room - size - 6), 6);
    setPlace([fit(pixel[0], element.offsetWidth, width), fit(pixel[1] - (above ? element.offsetHeight + 4 : 0), element.offsetHeight, height)]);
  }, [pixel, above, beside]);
  useEffect(() => {
    focusables(box.current)[0]?.focus({ preventScroll: true });
  }, []);

  const key = (event: KeyboardEvent<HTMLDivElement>) => {
    event.stopPropagation();
    const all = focusables(box.current);
    const at = all.indexOf(document.activeElement as HTMLElement);
    const typing = document.activeElement instanceof HTMLInputElement && document.activeElement.type === "text";
    if (event.key === "ArrowDown") all[(at + 1) % all.length]?.focus();
    else if (event.key === "ArrowUp") all[(at - 1 + all.length) % all.length]?.focus();
    else if (event.key === "Home" && !typing) all[0]?.focus();
    else if (event.key === "End" && !typing) all.at(-1)?.focus();
    else if (event.key === "Escape" || (event.key === "ArrowLeft" && beside && !typing)) (onBack ?? onClose)();
    else if (event.key === "Tab") onClose();
    else return;
    event.preventDefault();
  };

  const runs = runsOf(items);
  return (
    <div
      ref={box}
      className={beside ? "box pop-menu beside" : "box pop-menu"}
      role="group"
      aria-label={label}
      style={beside ? {} : { left: place[0], top: place[1] }}
      onKeyDown={key}
      onPointerDown={(event) => event.stopPropagation()}
      onContextMenu={(event) => event.preventDefault()}
    >
      {runs.map((run) => (
        <div key={run.from} {...(run.entries ? { role: "menu", "aria-label": label } : {})}>
          {run.items.map((item, k) => {
            const at = run.from + k;
            const onOpen = (on: boolean) => setOpen(on ? at : undefined);
            return <Entry key={at} item={item} open={open === at} onOpen={onOpen} onClose={onClose} />;
          })}
        </div>
      ))}
    </div>
  );
}

interface Run {
  from: number;
  /** Whether they are entries of a menu; fields and messages are not. */
  entries: boolean;
  items: Item[];
}

/** Entries that follow each other, apart from fields: a menu may hold nothing but entries. */
function runsOf(items: readonly Item[]): Run[] {
  const runs: Run[] = [];
  items.forEach((item, from) => {
    const entries = item.is === "do" || item.is === "more" || (item.is === "line" && runs.at(-1)?.entries === true);
    const last = runs.at(-1);
    if (last && (last.entries === entries || item.is === "line")) last.items.push(item);
    else runs.push({ from, entries, items: [item] });
  });
  return runs;
}

/** The entries of this menu itself, without those of menus beside it. */
function focusables(box: HTMLElement | null): HTMLElement[] {
  const all = box?.querySelectorAll<HTMLElement>("[role^=menuitem]:not([aria-disabled=true]), input") ?? [];
  return [...all].filter((element) => element.closest(".pop-menu") === box);
}

interface EntryProps {
  item: Item;
  open: boolean;
  onOpen(open: boolean): void;
  onClose(): void;
}

function Entry({ item, open, onOpen, onClose }: EntryProps) {
  switch (item.is) {
    case "line":
      return <hr />;
    case "told":
      return <p className={`message ${item.level}`}>{item.text}</p>;
    case "field":
      return <Field {...item} onClose={onClose} />;
    case "more":
      return <More item={item} open={open} onOpen={onOpen} onClose={onClose} />;
    case "do":
      return <Do item={item} onOpen={onOpen} onClose={onClose} />;
  }
}

function Do({ item, onOpen, onClose }: Omit<EntryProps, "item" | "open"> & { item: Extract<Item, { is: "do" }> }) {
  const run = () => {
    if (item.off) return;
    onClose();
    item.run();
  };
  return (
    <div
      className="item"
      role={item.on === undefined ? "menuitem" : "menuitemcheckbox"}
      aria-checked={item.on}
      aria-disabled={item.off}
      tabIndex={-1}
      onClick={run}
      onKeyDown={(event) => {
        if (event.key !== "Enter" && event.key !== " ") return;
        event.preventDefault();
        event.stopPropagation();
        run();
      }}
      onPointerEnter={(event) => {
        onOpen(false);
        event.currentTarget.focus({ preventScroll: true });
      }}
      onFocus={() => item.hover?.(true)}
      onBlur={() => item.hover?.(false)}
    >
      <span className="mark">{item.on ? "✓" : ""}</span>
      {item.label}
      {item.keys ? <kbd>{item.keys}</kbd> : null}
    </div>
  );
}

function More({ item, open, onOpen, onClose }: EntryProps & { item: Extract<Item, { is: "more" }> }) {
  const entry = useRef<HTMLDivElement>(null);
  return (
    <div className="more-entry" role="none" onPointerEnter={() => onOpen(true)}>
      <div
        ref={entry}
        className="item"
        role="menuitem"
        aria-haspopup="menu"
        aria-expanded={open}
        tabIndex={-1}
        // Pointing at it has opened it already: a click on it must not close it again.
        onClick={() => onOpen(true)}
        onKeyDown={(event) => {
          if (event.key !== "Enter" && event.key !== "ArrowRight" && event.key !== " ") return;
          event.preventDefault();
          event.stopPropagation();
          onOpen(true);
        }}
      >
        <span className="mark" />
        {item.label}
        <span aria-hidden="true">▸</span>
      </div>
      {open ? (
        <Menu
          items={item.items}
          pixel={[0, 0]}
          label={item.label}
          onClose={onClose}
          onBack={() => {
            onOpen(false);
            entry.current?.focus();
          }}
        />
      ) : null}
    </div>
  );
}

function Field({ label, value, take, onClose }: Extract<Item, { is: "field" }> & { onClose(): void }) {
  // The focus may go and come again: what was taken once is not taken twice, and what Escape left is not taken at all.
  const taken = useRef(value);
  const isLeft = useRef(false);
  const finish = (text: string) => {
    if (isLeft.current || text === taken.current) return;
    taken.current = text;
    take(text);
  };
  return (
    <label className="item field-item">
      <span className="mark" />
      <span>{label}</span>
      <input
        type="text"
        defaultValue={value}
        spellCheck={false}
        onBlur={(event) => finish(event.target.value)}
        onKeyDown={(event) => {
          if (event.key === "Enter") {
            finish(event.currentTarget.value);
            onClose();
          } else if (event.key === "Escape") {
            isLeft.current = true;
            onClose();
          } else if (!["ArrowDown", "ArrowUp", "Tab"].includes(event.key)) event.stopPropagation();
          if (event.key === "Enter" || event.key === "Escape") event.stopPropagation();
        }}
      />
    </label>
  );
}
