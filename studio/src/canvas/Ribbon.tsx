import { useEffect, useRef, useState } from "react";
import { useStore } from "zustand";

import { tabs, type CatalogueEntry } from "../core/catalogue";
import { t } from "../i18n";
import { Icon } from "../icons/Icon";
import { catalogueStore } from "../state/catalogue";
import { DRAGGED } from "./gestures/more";
import { useCanvas } from "./hooks";
import { place } from "./edits";
import { keyboardPlace } from "./open";
import { canvasStore } from "./store";
import { canvasPoint } from "./view";

/** The component tabs: a click and then a click on the canvas places, or a drag does. */
export function Ribbon() {
  const shown = useCanvas((canvas) => canvas.ribbon);
  const entries = useStore(catalogueStore, (catalogue) => catalogue.entries);
  const pointed = useCanvas((canvas) => canvas.pointedAt);
  const all = tabs(entries);
  const [chosen, setChosen] = useState<string | undefined>(undefined);
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
      <div role="tabpanel" aria-label={tab?.name}>
        {tab?.panels.map(({ name, entries: list }) => (
          <PanelOfEntries
            key={name}
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

interface PanelProps {
  name: string;
  entries: readonly CatalogueEntry[];
  open: boolean;
  onOpen(open: boolean): void;
  pointed: string | undefined;
}

/** A few of a panel's components, and all of them below when it is opened. */
function PanelOfEntries({ name, entries, open, onOpen, pointed }: PanelProps) {
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
      <div className="few">
        {entries.slice(0, 4).map((entry) => (
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
