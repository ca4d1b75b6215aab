import { useEffect, useId, useMemo, useRef, useState, type KeyboardEvent, type PointerEvent } from "react";

import { clamp, type Point } from "../../core/geometry";
import { middleOf, sectorAt, sectorPath, stepped, type Ring } from "../../core/radial";
import { t } from "../../i18n";
import { useCanvas } from "../hooks";
import { IconAt } from "../icons";
import { closeBoxes } from "../open";
import { paneSize } from "../view";
import { radialItems, type RadialItem } from "./radialItems";

const INNER = 46;
const OUTER = 108;
/** Half the side of the drawing. */
const REACH = OUTER + 6;

/** The ring of commands about the pointer: a middle click opens it. */
export function Radial() {
  const pixel = useCanvas((canvas) => canvas.radial);
  return pixel ? <Open key={pixel.join()} pixel={pixel} /> : null;
}

function Open({ pixel }: { pixel: Point }) {
  const root = useRef<HTMLDivElement>(null);
  const [hot, setHot] = useState<number | undefined>(undefined);
  const items = useMemo(() => radialItems(pixel), [pixel]);
  const id = useId();
  const ring: Ring = { count: items.length, inner: INNER, outer: OUTER };
  const [width, height] = paneSize();
  const left = clamp(pixel[0], REACH, Math.max(width - REACH, REACH));
  const top = clamp(pixel[1], REACH, Math.max(height - REACH, REACH));

  useEffect(() => {
    root.current?.focus({ preventScroll: true });
    const away = (event: globalThis.PointerEvent) => {
      if (event.target instanceof Node && !root.current?.contains(event.target)) closeBoxes();
    };
    window.addEventListener("pointerdown", away);
    return () => window.removeEventListener("pointerdown", away);
  }, []);

  const run = (index: number | undefined) => {
    const item = index === undefined ? undefined : items[index];
    if (item?.off) return;
    closeBoxes();
    item?.run();
  };
  const under = (event: PointerEvent) => {
    const box = root.current?.getBoundingClientRect();
    return box && sectorAt(ring, [event.clientX - box.left - REACH, event.clientY - box.top - REACH]);
  };
  const key = (event: KeyboardEvent) => {
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (by !== undefined) setHot(stepped(items.length, hot, by));
    else if (event.key === "Home") setHot(0);
    else if (event.key === "End") setHot(items.length - 1);
    else if (event.key === "Enter" || event.key === " ") run(hot);
    else if (event.key === "Escape" || event.key === "Tab") closeBoxes();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const told = hot === undefined ? undefined : items[hot];
  return (
    <div
      ref={root}
      className="box radial"
      role="menu"
      tabIndex={0}
      aria-label={t("canvas.radial")}
      aria-activedescendant={hot === undefined ? undefined : `${id}-${hot}`}
      style={{ left: left - REACH, top: top - REACH, width: 2 * REACH, height: 2 * REACH }}
      onPointerMove={(event) => setHot(under(event))}
      onPointerLeave={() => setHot(undefined)}
      onPointerDown={(event) => event.stopPropagation()}
      onPointerUp={(event) => event.button === 0 && run(under(event))}
      onKeyDown={key}
    >
      <svg viewBox={`${-REACH} ${-REACH} ${2 * REACH} ${2 * REACH}`} role="none">
        {items.map((item, index) => (
          <Sector key={item.id} id={`${id}-${index}`} item={item} ring={ring} index={index} hot={index === hot} />
        ))}
      </svg>
      <div className="hub" aria-hidden="true" style={{ inset: REACH - INNER + 4 }}>
        <span>{told?.label ?? ""}</span>
        {told?.keys ? <kbd>{told.keys}</kbd> : null}
      </div>
    </div>
  );
}

function Sector({ id, item, ring, index, hot }: { id: string; item: RadialItem; ring: Ring; index: number; hot: boolean }) {
  const states = [hot ? "hot" : "", item.off ? "off" : "", item.on ? "on" : ""];
  return (
    <g
      id={id}
      className={["sector", ...states].filter(Boolean).join(" ")}
      role="menuitem"
      aria-label={item.label}
      aria-disabled={item.off}
    >
      <path className="piece" d={sectorPath(ring, index, 3)} />
      <IconAt name={item.icon} at={middleOf(ring, index)} />
    </g>
  );
}
