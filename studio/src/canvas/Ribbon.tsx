import { useEffect, useLayoutEffect, useMemo, useRef, useState, type CSSProperties, type ReactNode, type RefObject, type WheelEvent } from "react";
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

/** The page of a phone, as the style sheets have it. */
const NARROW = matchMedia("(max-width: 720px)");

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
  // A phone has its height for the canvas: there the panels come with a press on their tab, and go when they are done with.
  const [isRolled, setRolled] = useState(() => NARROW.matches);
  const width = useWidth(bar, shown && all.length > 0 && !isRolled);
  const [open, setOpen] = useState<string | undefined>(undefined);
  const list = useRef<HTMLDivElement>(null);
  const tabEnds = useEnds(list, all.length);
  const home = entries.find((entry) => entry.guid === pointed);
  useEffect(() => {
    if (!home) return;
    setChosen(home.tab);
    setOpen(home.panel);
    setRolled(false);
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
      <div role="tablist" ref={list} aria-label={t("canvas.ribbon")} {...tabEnds}>
        {all.map(({ name }) => (
          <button
            key={name}
            type="button"
            role="tab"
            aria-selected={name === tab?.name}
            tabIndex={name === tab?.name ? 0 : -1}
            onClick={(event) => {
              setChosen(name);
              setOpen(undefined);
              setRolled(NARROW.matches && name === tab?.name && !isRolled);
              event.currentTarget.scrollIntoView({ block: "nearest", inline: "nearest" });
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
      <div role="tabpanel" aria-label={tab?.name} hidden={isRolled} ref={bar} onWheel={(event) => roll(bar.current, event)}>
        {panels.map(({ name, entries: list }, k) => (
          <PanelOfEntries
            key={name}
            columns={columns[k] ?? 1}
            name={name}
            entries={list}
            open={open === name}
            onOpen={(on) => setOpen(on ? name : undefined)}
            onDone={() => setRolled(NARROW.matches)}
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

/** How far a row fades out at an end beyond which it goes on, in pixels. */
const FADE = 28;

/** What a row needs that may be longer than its room: the wheel scrolls it, and it fades out where it goes on. */
function useEnds(of: RefObject<HTMLElement | null>, content: unknown) {
  const [ends, setEnds] = useState({ before: 0, after: 0 });
  const look = () => {
    const row = of.current;
    if (!row) return;
    const rest = row.scrollWidth - row.clientWidth - row.scrollLeft;
    const [before, after] = [row.scrollLeft > 1 ? FADE : 0, rest > 1 ? FADE : 0];
    setEnds((old) => (old.before === before && old.after === after ? old : { before, after }));
  };
  useEffect(() => {
    const row = of.current;
    if (!row) return undefined;
    const watcher = new ResizeObserver(look);
    watcher.observe(row);
    look();
    return () => watcher.disconnect();
  }, [of, content]);
  return {
    className: ends.before + ends.after > 0 ? "goes-on" : undefined,
    style: { "--before": `${ends.before}px`, "--after": `${ends.after}px` } as CSSProperties,
    onScroll: look,
    onWheel: (event: WheelEvent) => roll(of.current, event),
  };
}

/** A wheel that turns up and down moves a row; a sheet that hangs from it scrolls for itself. */
function roll(row: HTMLElement | null, event: WheelEvent): void {
  const isInSheet = event.target instanceof Element && event.target.closest(".all") !== null;
  if (row && event.deltaX === 0 && !isInSheet) row.scrollLeft += event.deltaY;
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
  /** A component of it was chosen. */
  onDone(): void;
  pointed: string | undefined;
}

/** A few of a panel's components, and all of them below when it is opened. */
function PanelOfEntries({ name, columns, entries, open, onOpen, onDone, pointed }: PanelProps) {
  const done = () => {
    onOpen(false);
    onDone();
  };
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
          <Entry key={entry.guid} entry={entry} short onDone={done} pointed={pointed} />
        ))}
      </div>
      <button type="button" className="more-of" aria-expanded={open} onClick={() => onOpen(!open)}>
        {name} <span aria-hidden="true">▾</span>
      </button>
      {open ? (
        <All below={box}>
          {entries.map((entry) => (
            <Entry key={entry.guid} entry={entry} short={false} onDone={done} pointed={pointed} />
          ))}
        </All>
      ) : null}
    </div>
  );
}

/** From a sheet to the edge of the page, in pixels. */
const EDGE = 6;

/** A sheet below a panel, moved to the left as far as it must for all of it to be on the page. */
function All({ below, children }: { below: RefObject<HTMLElement | null>; children: ReactNode }) {
  const sheet = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    const [element, panel] = [sheet.current, below.current?.getBoundingClientRect()];
    if (!element || !panel) return;
    const left = Math.max(EDGE, Math.min(panel.left, innerWidth - element.offsetWidth - EDGE));
    Object.assign(element.style, { left: `${left}px`, top: `${panel.bottom}px` });
    element.style.maxHeight = `${innerHeight - panel.bottom - EDGE}px`;
  }, [below]);
  return (
    <div className="all" ref={sheet}>
      {children}
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
