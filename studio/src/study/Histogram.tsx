import { ticks } from "d3-array";
import { useMemo } from "react";

import { t } from "../i18n";
import { AxisChoice } from "./AxisChoice";
import { type Axis, label, shown } from "./core/axes";
import { type Bar, barsOf } from "./core/bars";
import type { Derived } from "./derived";
import { useWidth } from "./size";
import { brush, set } from "./store";

const HEIGHT = 190;
const [LEFT, RIGHT, TOP, BOTTOM] = [44, 10, 10, 150];

/** How many points there are in each part of a column: all of them, and the selected ones in front. */
export function Histogram({ axes, bars: axis, selected }: Derived) {
  const [frame, width] = useWidth<HTMLDivElement>();
  const bars = useMemo(() => (axis ? barsOf(axis, selected) : []), [axis, selected]);
  if (!axis) return null;
  const most = Math.max(1, ...bars.map(({ all }) => all));
  const fullest = bars.find(({ all }) => all === most);
  const [low, high] = [bars[0]?.low ?? 0, bars[bars.length - 1]?.high ?? 1];
  const across = (x: number) => LEFT + ((x - low) / (high - low)) * (width - LEFT - RIGHT);
  const up = (count: number) => BOTTOM - (count / most) * (BOTTOM - TOP);
  const said = { name: axis.name, bars: bars.length, most, low: edge(axis, fullest, "low"), high: edge(axis, fullest, "high") };
  const marks = axis.words ? axis.words.map((_, at) => at) : ticks(low, high, width < 360 ? 4 : 7);
  return (
    <section className="panel histogram" aria-labelledby="histogram-title">
      <div className="panel-head">
        <h2 id="histogram-title">{t("study.histogram")}</h2>
        <AxisChoice label={t("study.histogram.column")} axes={axes} value={axis.key} onChange={(key) => set({ bars: key })} />
      </div>
      <div ref={frame} className="field">
        {width > 0 && (
          <svg className="grid" width={width} height={HEIGHT} role="img" aria-label={t("study.histogram.said", said)}>
            {ticks(0, most, 4).filter(Number.isInteger).map((count) => (
              <g key={count}>
                <line x1={LEFT} x2={width - RIGHT} y1={up(count)} y2={up(count)} />
                <text x={LEFT - 6} y={up(count)} dy="0.32em" textAnchor="end">{count}</text>
              </g>
            ))}
            {bars.map((bar) => (
              <g key={bar.low} className="bar" onClick={() => brush(axis, [bar.low, bar.high])}>
                <title>{t("study.histogram.bar", { low: edge(axis, bar, "low"), high: edge(axis, bar, "high"), selected: bar.selected, all: bar.all })}</title>
                <rect className="reach" x={across(bar.low)} width={Math.max(0, across(bar.high) - across(bar.low))} y={TOP} height={BOTTOM - TOP} />
                <rect className="all" x={across(bar.low) + 0.5} width={Math.max(1, across(bar.high) - across(bar.low) - 1)} y={up(bar.all)} height={BOTTOM - up(bar.all)} />
                <rect className="chosen" x={across(bar.low) + 0.5} width={Math.max(1, across(bar.high) - across(bar.low) - 1)} y={up(bar.selected)} height={BOTTOM - up(bar.selected)} />
              </g>
            ))}
            {marks.map((at) => <text key={at} x={across(at)} y={BOTTOM + 16} textAnchor="middle">{label(axis, at)}</text>)}
            <text className="name" x={(LEFT + width - RIGHT) / 2} y={HEIGHT - 6} textAnchor="middle">{axis.name}</text>
          </svg>
        )}
      </div>
    </section>
  );
}

function edge(axis: Axis, bar: Bar | undefined, end: "low" | "high"): string {
  if (!bar) return "";
  return axis.words ? label(axis, bar.low + 0.5) : shown(bar[end]);
}
