import { ticks } from "d3-array";
import { quadtree } from "d3-quadtree";
import { type KeyboardEvent, type PointerEvent, useEffect, useMemo, useRef, useState } from "react";

import { t } from "../i18n";
import { AxisChoice } from "./AxisChoice";
import { type Axis, cellText, label } from "./core/axes";
import type { Derived } from "./derived";
import { Key } from "./Key";
import { byColour } from "./parallelDrawing";
import { between, crosses, diamonds, dots, type Field, path, spot } from "./scatterDrawing";
import { sized, useWidth } from "./size";
import { look, set, useChosen } from "./store";
import { ink } from "./theme";

const HEIGHT = 460;
/** A point is found from so many pixels away. */
const REACH = 14;

/** A column over another. */
export function Scatter(derived: Derived) {
  const { study, axes, x, y, colour, places, selected, good, steps, colours, front, onFront, theme, goals } = derived;
  const [frame, width] = useWidth<HTMLDivElement>();
  const canvas = useRef<HTMLCanvasElement>(null);
  const [over, setOver] = useState<number | undefined>(undefined);
  const field: Field | undefined = useMemo(() => x && y && { x, y, left: 86, right: Math.max(120, width - 14), top: 12, bottom: HEIGHT - 62 }, [x, y, width]);
  const point = useChosen((one) => one.point);
  const current = useMemo(() => (point === undefined ? -1 : study.rows.findIndex((row) => row.point === point)), [study.rows, point]);

  useEffect(() => {
    const request = requestAnimationFrame(() => {
      const context = canvas.current && field && width > 0 && sized(canvas.current, width, HEIGHT);
      if (!context || !field) return;
      const radius = places.length > 3000 ? 2.2 : places.length > 300 ? 3 : 4;
      const others = [...selected.keys()].filter((row) => selected[row] === 0);
      context.globalAlpha = 0.35;
      context.fillStyle = ink("--line");
      dots(context, field, others.filter((row) => good[row] === 1), 1.8, others.length);
      context.strokeStyle = ink("--line");
      crosses(context, field, others.filter((row) => good[row] === 0), 2.5);
      context.globalAlpha = places.length > 3000 ? 0.6 : 0.85;
      byColour(places.filter((row) => good[row] === 1 && !onFront.has(row)), steps, colours.length).forEach((rows, step) => {
        context.fillStyle = colours[step] ?? ink("--ink-soft");
        dots(context, field, rows, radius, places.length);
      });
      context.globalAlpha = 1;
      [context.strokeStyle, context.lineWidth] = [ink("--error"), 1.6];
      crosses(context, field, places.filter((row) => good[row] === 0), 4);
      [context.strokeStyle, context.lineWidth] = [ink("--ink"), 1.2];
      if (goals.size === 2 && goals.has(field.x.key) && goals.has(field.y.key)) path(context, field, front);
      for (const row of front) {
        context.fillStyle = colours[steps[row] ?? 0] ?? ink("--ink-soft");
        diamonds(context, field, [row], 6);
      }
      if (current < 0) return;
      const [cx, cy] = spot(field, current);
      for (const [radius, thick, colour] of [[10, 5, "--raised"], [10, 2.5, "--focus"]] as const) {
        [context.strokeStyle, context.lineWidth] = [ink(colour), thick];
        context.beginPath();
        context.arc(cx, cy, radius, 0, 2 * Math.PI);
        context.stroke();
      }
    });
    return () => cancelAnimationFrame(request);
  }, [field, selected, places, good, steps, colours, front, onFront, current, goals, theme, width]);

  const tree = useMemo(() => {
    if (!field) return undefined;
    const find = quadtree<number>().x((row) => spot(field, row)[0]).y((row) => spot(field, row)[1]);
    return find.addAll([...places]);
  }, [field, places]);
  const rowAt = (event: PointerEvent) => {
    const box = canvas.current?.getBoundingClientRect();
    return box && tree?.find(event.clientX - box.left, event.clientY - box.top, REACH);
  };
  const choose = (row: number | undefined) => {
    const found = row === undefined ? undefined : study.rows[row];
    if (found) look(found.point);
  };
  const key = (event: KeyboardEvent) => {
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (by === undefined || !field) return;
    event.preventDefault();
    const order = [...places].sort((a, b) => (field.x.values[a] ?? 0) - (field.x.values[b] ?? 0) || (field.y.values[a] ?? 0) - (field.y.values[b] ?? 0));
    const at = order.indexOf(current);
    const next = order[at < 0 ? 0 : Math.min(order.length - 1, Math.max(0, at + by))];
    const row = next === undefined ? undefined : study.rows[next];
    if (row) set({ point: row.point });
  };
  const said = { x: x?.name ?? "", y: y?.name ?? "", selected: places.length, count: study.rows.length, front: front.length };
  const hovered = over === undefined ? undefined : study.rows[over];
  return (
    <section className="panel scatter" aria-labelledby="scatter-title">
      <div className="panel-head">
        <h2 id="scatter-title">{t("study.scatter")}</h2>
        <AxisChoice label={t("study.x")} axes={axes} value={x?.key ?? ""} onChange={(key) => set({ x: key })} />
        <AxisChoice label={t("study.y")} axes={axes} value={y?.key ?? ""} onChange={(key) => set({ y: key })} />
        <AxisChoice label={t("study.colour")} axes={axes} value={colour?.key ?? ""} onChange={(key) => set({ colour: key })}>
          <option value="">{t("study.colour.none")}</option>
        </AxisChoice>
      </div>
      <div ref={frame} className="field" style={{ height: HEIGHT }}>
        {field && <Grid field={field} width={width} />}
        <canvas
          ref={canvas}
          style={{ width, height: HEIGHT }}
          role="img"
          tabIndex={0}
          aria-label={t("study.scatter.said", said)}
          onKeyDown={key}
          onPointerMove={(event) => setOver(rowAt(event))}
          onPointerLeave={() => setOver(undefined)}
          onClick={(event) => choose(rowAt(event as unknown as PointerEvent))}
        />
        {hovered && over !== undefined && field && (
          <div className="tip" style={{ left: Math.min(spot(field, over)[0] + 14, width - 150), top: spot(field, over)[1] + 10 }} aria-hidden="true">
            <b>{t("study.point", { point: hovered.point })}</b>
            {[x, y, colour].filter((axis) => axis !== undefined).map((axis) => <div key={axis.key}>{axis.name}: {valueOf(axis, over)}</div>)}
            {good[over] === 0 && <div>{hovered.status}: {hovered.reason}</div>}
          </div>
        )}
      </div>
      <Key hasFront={front.length > 0} hasFailed={good.includes(0)} />
    </section>
  );
}

function valueOf(axis: Axis, row: number): string {
  const value = axis.values[row] ?? NaN;
  return Number.isNaN(value) ? t("study.noValue") : axis.words ? label(axis, value) : cellText(value);
}

/** The axes behind the points. */
function Grid({ field, width }: { field: Field; width: number }) {
  const { x, y, left, right, top, bottom } = field;
  const marks = (axis: Axis, count: number) => (axis.words ? axis.words.map((_, at) => at) : ticks(...axis.domain, count));
  return (
    <svg className="grid" width={width} height={HEIGHT} aria-hidden="true">
      {marks(x, width < 500 ? 4 : 8).map((at) => {
        const place = between(x, at, left, right);
        return (
          <g key={at}>
            <line x1={place} x2={place} y1={top} y2={bottom} />
            <text x={place} y={bottom + 34} textAnchor="middle">{label(x, at)}</text>
          </g>
        );
      })}
      {marks(y, 7).map((at) => {
        const place = between(y, at, bottom, top);
        return (
          <g key={at}>
            <line x1={left} x2={right} y1={place} y2={place} />
            <text x={left - 22} y={place} dy="0.32em" textAnchor="end">{label(y, at)}</text>
          </g>
        );
      })}
      <path className="frame" d={`M${left},${top}V${bottom}H${right}`} />
      <text className="name" x={(left + right) / 2} y={HEIGHT - 6} textAnchor="middle">{x.name}</text>
      <text className="name" transform={`translate(12 ${(top + bottom) / 2}) rotate(-90)`} textAnchor="middle">{y.name}</text>
    </svg>
  );
}
