import { useEffect, useId, useRef, useState, type ReactNode } from "react";

import type { Point } from "../../core/geometry";
import { closeBoxes } from "../open";
import { paneSize } from "../view";

export interface Pick {
  key: string;
  label: ReactNode;
  /** A picture before the label. */
  icon?: ReactNode;
  /** What kind of thing it is, in the second column. */
  hint: string;
  run(): void;
}

interface PickListProps {
  pixel: Point;
  label: string;
  /** What stands in the field while it is empty. */
  prompt: string;
  none: string;
  /** Whether that nothing is found is said before anything is typed. */
  always?: boolean;
  picks(query: string): Pick[];
  onQuery?(query: string): void;
  onHighlight?(key: string | undefined): void;
}

const WIDTH = 320;
const HEIGHT = 380;

/** A field to type in and a list to choose from: arrows go through it, Enter takes, Escape closes. */
export function PickList({ pixel, label, prompt, none, always = false, picks, onQuery, onHighlight }: PickListProps) {
  const [query, setQuery] = useState("");
  const [at, setAt] = useState(0);
  const field = useRef<HTMLInputElement>(null);
  const list = useRef<HTMLUListElement>(null);
  const id = useId();
  const found = picks(query);
  const chosen = Math.min(at, found.length - 1);
  const key = found[chosen]?.key;

  useEffect(() => field.current?.focus(), []);
  useEffect(() => onQuery?.(query), [query, onQuery]);
  useEffect(() => {
    list.current?.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: "nearest" });
    onHighlight?.(key);
  }, [key, onHighlight]);

  const [width, height] = paneSize();
  const left = Math.max(Math.min(pixel[0] - 20, width - WIDTH - 8), 8);
  const top = Math.max(Math.min(pixel[1] - 18, height - HEIGHT - 8), 8);
  const take = (pick: Pick | undefined) => {
    if (!pick) return;
    closeBoxes();
    pick.run();
  };
  const go = (by: number) => setAt((chosen + by + found.length) % Math.max(found.length, 1));
  return (
    <div
      className="box pick-list"
      style={{ left, top, width: WIDTH }}
      onPointerDown={(event) => event.stopPropagation()}
      onBlur={(event) => {
        if (!event.currentTarget.contains(event.relatedTarget)) closeBoxes();
      }}
    >
      <input
        ref={field}
        type="text"
        role="combobox"
        aria-label={label}
        aria-expanded="true"
        aria-controls={`${id}-list`}
        aria-activedescendant={key === undefined ? undefined : `${id}-${chosen}`}
        autoComplete="off"
        spellCheck={false}
        placeholder={prompt}
        value={query}
        onChange={(event) => {
          setQuery(event.target.value);
          setAt(0);
        }}
        onKeyDown={(event) => {
          if (event.nativeEvent.isComposing) return;
          event.stopPropagation();
          if (event.key === "Escape") closeBoxes();
          else if (event.key === "Enter") take(found[chosen]);
          else if (event.key === "ArrowDown") go(1);
          else if (event.key === "ArrowUp") go(-1);
          else return;
          event.preventDefault();
        }}
      />
      <ul ref={list} id={`${id}-list`} role="listbox" aria-label={label}>
        {found.map((pick, k) => (
          <li
            key={pick.key}
            id={`${id}-${k}`}
            role="option"
            aria-selected={k === chosen}
            onPointerMove={() => setAt(k)}
            onPointerDown={(event) => {
              event.preventDefault();
              take(pick);
            }}
          >
            <span>
              {pick.icon}
              {pick.label}
            </span>
            <small>{pick.hint}</small>
          </li>
        ))}
      </ul>
      {found.length === 0 && (query !== "" || always) ? <p className="none">{none}</p> : null}
    </div>
  );
}
