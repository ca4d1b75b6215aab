import { useEffect, useMemo, useRef } from "react";

import { t } from "../i18n";
import { AxisBrush } from "./AxisBrush";
import type { Derived } from "./derived";
import { Legend } from "./Legend";
import { paint } from "./painter";
import { byColour, type Lines, strength, strokeRows } from "./parallelDrawing";
import { sized, useWidth } from "./size";
import { useChosen } from "./store";
import { ink } from "./theme";

const HEIGHT = 330;
const TOP = 52;
/** An axis takes at least so many pixels; where there are more, the plot scrolls. */
const APART = 96;
const SIDE = 56;

/** An axis a column, a line a point. */
export function Parallel(derived: Derived) {
  const { axes, study, places, good, steps, colours, theme, onFront, colour } = derived;
  const [frame, width] = useWidth<HTMLDivElement>();
  const others = useRef<HTMLCanvasElement>(null);
  const chosen = useRef<HTMLCanvasElement>(null);
  const lone = useRef<HTMLCanvasElement>(null);
  const wide = Math.max(width, axes.length * APART);
  const hasGaps = useMemo(() => axes.some(({ values }) => values.some(Number.isNaN)), [axes]);
  const bottom = HEIGHT - (hasGaps ? 44 : 18);
  const lines: Lines = useMemo(() => {
    const step = axes.length > 1 ? (wide - 2 * SIDE) / (axes.length - 1) : 0;
    return { axes, xs: axes.map((_, k) => (axes.length > 1 ? SIDE + k * step : wide / 2)), top: TOP, bottom, gap: bottom + 24 };
  }, [axes, wide, bottom]);

  // Behind: all rows, pale. It stays while brushes move.
  useEffect(() => {
    const context = others.current && width > 0 && sized(others.current, wide, HEIGHT);
    if (!context) return;
    const style = () => {
      context.strokeStyle = ink("--line");
      context.globalAlpha = strength(study.rows.length) * 0.45;
    };
    return paint([{ rows: [...study.rows.keys()], style }], () => undefined, (rows) => strokeRows(context, lines, rows));
  }, [study.rows, lines, theme, wide, width]);

  const point = useChosen((one) => one.point);
  const current = useMemo(() => (point === undefined ? -1 : study.rows.findIndex((row) => row.point === point)), [study.rows, point]);

  // In front: the selection. Those without results are dashed and lie behind the others; the front is drawn last, and thick.
  useEffect(() => {
    const canvas = chosen.current;
    const context = canvas?.getContext("2d");
    if (!canvas || !context || width === 0) return;
    const [soft, error] = [ink("--ink-soft"), ink("--error")];
    const style = (colour: string, alpha: number, thick: number, dash: number[]) => () => {
      [context.strokeStyle, context.globalAlpha, context.lineWidth] = [colour, alpha, thick];
      context.setLineDash(dash);
    };
    const failed = places.filter((row) => good[row] === 0);
    const jobs = [
      { rows: failed, style: style(error, Math.min(0.8, 6 / Math.sqrt(failed.length + 1)), 1, [6, 4]) },
      ...byColour(places.filter((row) => good[row] === 1), steps, colours.length).map((rows, step) => ({ rows, style: style(colours[step] ?? soft, strength(places.length), 1, []) })),
      ...byColour([...onFront], steps, colours.length).map((rows, step) => ({ rows, style: style(colours[step] ?? soft, 1, 2, []) })),
    ];
    return paint(jobs, () => sized(canvas, wide, HEIGHT), (rows) => strokeRows(context, lines, rows));
  }, [lines, places, good, steps, colours, onFront, theme, wide, width]);

  // Before all: the point that is looked at.
  useEffect(() => {
    const context = lone.current && width > 0 && sized(lone.current, wide, HEIGHT);
    if (!context || current < 0) return;
    context.lineJoin = "round";
    for (const [colour, thick] of [[ink("--raised"), 7], [ink("--ink"), 3]] as const) {
      [context.strokeStyle, context.lineWidth] = [colour, thick];
      strokeRows(context, lines, [current]);
    }
  }, [lines, current, theme, wide, width]);

  return (
    <section className="panel parallel" aria-labelledby="parallel-title">
      <div className="panel-head">
        <h2 id="parallel-title">{t("study.parallel")}</h2>
        <p className="unseen">{t("study.parallel.help")}</p>
        {colour && <Legend axis={colour} colours={colours} />}
      </div>
      <div className="scrolls" ref={frame} tabIndex={0} role="group" aria-label={t("study.parallel.said", { count: study.rows.length, axes: axes.length, selected: places.length })}>
        <div className="layers" style={{ width: wide, height: HEIGHT }}>
          <canvas ref={others} style={{ width: wide, height: HEIGHT }} aria-hidden="true" />
          <canvas ref={chosen} style={{ width: wide, height: HEIGHT }} aria-hidden="true" />
          <canvas ref={lone} style={{ width: wide, height: HEIGHT }} aria-hidden="true" />
          {hasGaps && <span className="gap-label" style={{ top: bottom + 15 }}>{t("study.noValue")}</span>}
          {axes.map((axis, k) => (
            <AxisBrush key={axis.key} axis={axis} x={lines.xs[k] ?? 0} top={TOP} bottom={bottom} />
          ))}
        </div>
      </div>
    </section>
  );
}
