import { useEffect, useMemo, useRef, useState, type RefObject } from "react";
import { useStore } from "zustand";

import { tabs, type CatalogueEntry } from "../core/catalogue";
import { columnsOf, ROWS } from "../core/ribbon";
import { t } from "../i18n";
import { Icon } from "../icons/Icon";
import { catalogueStore } from "../state/catalogue";
import { DRAGGED } from "./gestures/more";
import { useCanvas } from "./hooks";
import { place } from "./edits";
import { keyboardPlace } from "./open";
import { canvasStore, keep } from "./store";
import { canvasPoint } from "./view";

/** The room of a button with the gap beside it, and of a panel's borders, in pixels. */
const BUTTON = 30;
const FRAME = 14;
/** About how wide a letter of a panel's name is, and what stands beside the name. */
const LETTER = 6;
const BESIDE = 26;

/** The component tabs: a click and then a click on the canvas places, or a drag does. */
export function Ribbon() {
  const shown = useCanvas((canvas) => canvas.ribbon);
  const entries = useStore(catalogueStore, (catalogue) => catalogue.entries);
  const pointed = useCanvas((canvas) => canvas.pointedAt);
  const all = useMemo(() => tabs(entries), [entries]);
  // The tab that was used last is there again the next time.
  const chosen = useCanvas((canvas) => canvas.tab);
  const setChosen = (tab: string | undefined) => keep({ tab });
  const recent = useRecent();
  const bar = useRef<HTMLDivElement>(null);
  const width = useWidth(bar, shown && all.length > 0);
  const [open, setOpen] = useState<string | undefined>(undefined);
  const list = useRef<HTMLDivElement>(null);
  const home = entries.find((entry) => entry.guid === pointed);
  useEffect(() => {
    if (!home) return;
    setChosen(home.tab);
    setOpen(home.panel);
  }, [home]);
  if (!shown || all.length === 0) return null;
  const tab = all.find((one) => one.name === chosen) ?? all[0];
  const panels = [...(recent.length > 0 ? [{ name: t("canvas.ribbon.recent"), entries: recent }] : []), ...(tab?.panels ?? [])];
  const counts = panels.map((panel) => panel.entries.length);
  const least = panels.map(({ name }) => Math.ceil((name.length * LETTER + BESIDE - FRAME) / BUTTON));
  const columns = columnsOf(counts, width, BUTTON, FRAME, least);
  const step = (by: number) => {
    const at = all.findIndex((one) => one === tab);
    const next = (at + by + all.length) % all.length;
    setChosen(all[next]?.name);
    setOpen(undefined);
    list.current?.querySelectorAll<HTMLElement>('[role="tab"]')[next]?.focus();
  };
  return (
    <div className="ribbon">
      <div role="tablist" ref={list} aria-label={t("canvas.ribbon")}>
        {all.map(({ name }) => (
          <button
            key={name}
            type="button"
            role="tab"
            aria-selected={name === tab?.name}
            tabIndex={name === tab?.name ? 0 : -1}
            onClick={() => {
              setChosen(name);
              setOpen(undefined);
            }}
            onKeyDown={(event) => {
              if (event.key === "ArrowRight") step(1);
              if (event.key === "ArrowLeft") step(-1);
            }}
          >
            {name}
          </button>
        ))}
      </div>
      <div role="tabpanel" aria-label={tab?.name} ref={bar}>
        {panels.map(({ name, entries: list }, k) => (
          <PanelOfEntries
            key={name}
            columns={columns[k] ?? 1}
            name={name}
            entries={list}
            open={open === name}
            onOpen={(on) => setOpen(on ? name : undefined)}
            pointed={pointed}
          />
        ))}
      </div>
    </div>
  );
}

/** The components that were placed lately. */
function useRecent(): CatalogueEntry[] {
  const recent = useCanvas((canvas) => canvas.recent);
  const byId = useStore(catalogueStore, (catalogue) => catalogue.byId);
  return recent.flatMap((guid) => byId.get(guid) ?? []).slice(0, ROWS * 2);
}

/** How wide an element is, now and when that changes. */
function useWidth(of: RefObject<HTMLElement | null>, isThere: boolean): number {
  const [width, setWidth] = useState(0);
  useEffect(() => {
    const element = of.current;
    if (!element) return undefined;
    const watcher = new ResizeObserver(() => setWidth(element.clientWidth));
    watcher.observe(element);
    return () => watcher.disconnect();
  }, [of, isThere]);
  return width;
}

interface PanelProps {
  name: string;
  columns: number;
  entries: readonly CatalogueEntry[];
  open: boolean;
  onOpen(open: boolean): void;
  pointed: string | undefined;
}

/** A few of a panel's components, and all of them below when it is opened. */
function PanelOfEntries({ name, columns, entries, open, onOpen, pointed }: PanelProps) {
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!open) return undefined;
    const close = (event: PointerEvent) => {
      if (event.target instanceof Node && !box.current?.contains(event.target)) onOpen(false);
    };
    window.addEventListener("pointerdown", close);
    return () => window.removeEventListener("pointerdown", close);
  }, [open, onOpen]);
  return (
    <div className="ribbon-panel" ref={box}>
      <div className="few" style={{ gridTemplateColumns: `repeat(${columns}, ${BUTTON - 2}px)` }}>
        {entries.slice(0, columns * ROWS).map((entry) => (
          <Entry key={entry.guid} entry={entry} short onDone={() => onOpen(false)} pointed={pointed} />
        ))}
      </div>
      <button type="button" className="more-of" aria-expanded={open} onClick={() => onOpen(!open)}>
        {name} <span aria-hidden="true">▾</span>
      </button>
      {open ? (
        <div className="all">
          {entries.map((entry) => (
            <Entry key={entry.guid} entry={entry} short={false} onDone={() => onOpen(false)} pointed={pointed} />
          ))}
        </div>
      ) : null}
    </div>
  );
}

interface EntryProps {
  entry: CatalogueEntry;
  short: boolean;
  pointed: string | undefined;
  onDone(): void;
}

function Entry({ entry, short, pointed, onDone }: EntryProps) {
  const placing = useCanvas((canvas) => canvas.placing?.guid === entry.guid);
  return (
    <button
      type="button"
      className={`entry ${pointed === entry.guid ? "pointed" : ""} ${placing ? "placing" : ""}`}
      title={`${entry.name}\n${entry.help}`}
      aria-label={entry.name}
      draggable
      onDragStart={(event) => {
        event.dataTransfer.setData(DRAGGED, entry.guid);
        event.dataTransfer.effectAllowed = "copy";
      }}
      onClick={(event) => {
        // A key has no place on the canvas to click at.
        if (event.detail === 0) void place({ component: entry.guid, with: null }, canvasPoint(keyboardPlace()));
        else canvasStore.setState({ placing: entry, pointedAt: undefined });
        onDone();
      }}
    >
      <Icon component={entry.guid} name={entry.name} />
      {short ? null : entry.name}
    </button>
  );
}
