import { ticks } from "d3-array";
import { type KeyboardEvent, memo, type PointerEvent, useRef } from "react";

import { t } from "../i18n";
import { type Axis, label, shown } from "./core/axes";
import { moved, type Range, stepOf } from "./core/brushes";
import { rangeText } from "./Filters";
import { heightOf } from "./parallelDrawing";
import { brush, useChosen } from "./store";

interface Props {
  axis: Axis;
  x: number;
  top: number;
  bottom: number;
}

/** What a drag moves. */
type Drag = { is: "new"; from: number } | { is: "whole"; from: number; range: Range } | { is: "low" | "high"; range: Range };

/** A press nearer than this to an end of the brush takes that end. */
const NEAR = 9;

/** A place nearer than this to an end of the axis is that end. */
const SNAP = 6;

/** An axis with its name, its ticks and its brush. */
export const AxisBrush = memo(function AxisBrush({ axis, x, top, bottom }: Props) {
  const brushed = useChosen((chosen) => chosen.brushes.get(axis.key));
  const range: Range = brushed ?? axis.domain;
  const drag = useRef<Drag | undefined>(undefined);
  const area = useRef<HTMLDivElement>(null);
  const place = { top, bottom, gap: bottom };
  const height = (value: number) => heightOf(axis, value, place);
  const valueAt = (event: PointerEvent) => {
    const y = event.clientY - (area.current?.getBoundingClientRect().top ?? 0);
    const [low, high] = axis.domain;
    // Who begins or ends near the end of the axis means the end: the largest value is not left out by a pixel.
    if (y < SNAP) return high;
    if (y > bottom - top - SNAP) return low;
    return low + (1 - y / (bottom - top)) * (high - low);
  };
  const down = (event: PointerEvent<HTMLDivElement>) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    const at = valueAt(event);
    const near = (value: number) => Math.abs(height(value) - height(at)) < NEAR;
    if (brushed && near(brushed[1])) drag.current = { is: "high", range: brushed };
    else if (brushed && near(brushed[0])) drag.current = { is: "low", range: brushed };
    else if (brushed && at > brushed[0] && at < brushed[1]) drag.current = { is: "whole", from: at, range: brushed };
    else drag.current = { is: "new", from: at };
  };
  const move = (event: PointerEvent<HTMLDivElement>) => {
    const dragged = drag.current;
    if (!dragged) return;
    const at = valueAt(event);
    if (dragged.is === "new") {
      // A press that hardly moves is a click.
      if (Math.abs(height(at) - height(dragged.from)) > 3) brush(axis, around(axis, dragged.from, at));
    } else if (dragged.is === "whole") {
      const [low, high] = dragged.range;
      const [least, most] = axis.domain;
      const by = Math.min(most - high, Math.max(least - low, at - dragged.from));
      brush(axis, axis.words ? [low + Math.round(by), high + Math.round(by)] : [low + by, high + by]);
    } else {
      const to = axis.words ? Math.round(at + 0.5) - 0.5 : at;
      brush(axis, moved(axis, dragged.range, dragged.is, to));
    }
  };
  const up = (event: PointerEvent<HTMLDivElement>) => {
    const dragged = drag.current;
    drag.current = undefined;
    if (dragged?.is === "new" && Math.abs(height(valueAt(event)) - height(dragged.from)) <= 3) brush(axis, undefined);
  };
  const key = (event: KeyboardEvent, end: "low" | "high") => {
    const now = end === "low" ? range[0] : range[1];
    const [least, most] = axis.domain;
    const targets: Record<string, number> = {
      ArrowUp: now + stepOf(axis, event.shiftKey),
      ArrowRight: now + stepOf(axis, event.shiftKey),
      ArrowDown: now - stepOf(axis, event.shiftKey),
      ArrowLeft: now - stepOf(axis, event.shiftKey),
      PageUp: now + stepOf(axis, true),
      PageDown: now - stepOf(axis, true),
      Home: least,
      End: most,
    };
    const to = targets[event.key];
    if (to !== undefined) brush(axis, moved(axis, range, end, to));
    else if (event.key === "Delete" || event.key === "Backspace" || event.key === "Escape") brush(axis, undefined);
    else return;
    event.preventDefault();
  };
  const handle = (end: "low" | "high") => {
    const value = end === "low" ? range[0] : range[1];
    return (
      <span
        className={`handle ${end}`}
        style={{ top: height(value) - top }}
        role="slider"
        tabIndex={0}
        aria-orientation="vertical"
        aria-label={t(`study.axis.${end}`, { name: axis.name })}
        aria-valuemin={axis.domain[0]}
        aria-valuemax={axis.domain[1]}
        aria-valuenow={value}
        aria-valuetext={axis.words ? rangeText(axis, range) : shown(value)}
        onKeyDown={(event) => key(event, end)}
      />
    );
  };
  const marks = axis.words ? axis.words.map((_, at) => at) : ticks(...axis.domain, 6);
  return (
    <div className={brushed ? "axis brushed" : "axis"} style={{ left: x, top, height: bottom - top }} data-axis={axis.key}>
      <span className="axis-name" title={axis.name}>{axis.name}</span>
      {axis.kind !== "status" && <span className="axis-kind">{t(`study.axis.${axis.kind}`)}</span>}
      {marks.map((at) => (
        <span key={at} className="tick" style={{ top: height(at) - top }} aria-hidden="true">{label(axis, at)}</span>
      ))}
      <div ref={area} className="brush-area" onPointerDown={down} onPointerMove={move} onPointerUp={up} onPointerCancel={() => (drag.current = undefined)}>
        {brushed && <div className="brush" style={{ top: height(range[1]) - top, height: Math.max(2, height(range[0]) - height(range[1])) }} />}
      </div>
      {handle("high")}
      {handle("low")}
    </div>
  );
});

/** The range between two places; for words, with those that it touches. */
function around(axis: Axis, a: number, b: number): Range {
  if (!axis.words) return [a, b];
  return [Math.round(Math.min(a, b)) - 0.5, Math.round(Math.max(a, b)) + 0.5];
}
