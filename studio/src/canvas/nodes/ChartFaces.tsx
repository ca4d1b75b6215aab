import type { ReactNode } from "react";

import { IDS } from "../../core/catalogue";
import { type History, barChart, branchesOf, lineOf, numbersOf, partsOf, remember, shortNumber, slicesOf, told } from "../../core/charts";
import type { Point } from "../../core/geometry";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { useOutput } from "../hooks";
import { useRows } from "../rows";

/** More rows than this are not drawn: nobody could tell them apart. */
const MOST_ROWS = 4000;
/** More values than this are not followed. */
const MOST_TRACKS = 24;
/** The room beside a chart. */
const EDGE = 6;
/** How many colours there are. */
const COLOURS = 8;

const CHARTS: ReadonlyMap<string, (branches: string[][], room: Point) => { words: string[]; drawn: ReactNode }> = new Map([
  [IDS.quickGraph, line],
  [IDS.barGraph, bars],
  [IDS.pieChart, pie],
]);

/** Whether an object draws its data as a chart. */
export function isChart(object: ObjectView): boolean {
  return CHARTS.has(object.component) || object.component === IDS.valueTracker;
}

/** What a tracker has seen so far, and in what data last. */
const SEEN = new Map<string, { page: object; history: History }>();

function draw(object: ObjectView, branches: string[][], room: Point, page: object) {
  if (object.component !== IDS.valueTracker) return CHARTS.get(object.component)?.(branches, room);
  let seen = SEEN.get(object.id);
  if (seen?.page !== page) {
    seen = { page, history: remember(seen?.history ?? [], numbersOf(branches.flat())) };
    SEEN.set(object.id, seen);
  }
  return tracks(seen.history, room);
}

/** A Value Tracker, Quick Graph, Bar Graph or Pie Chart: its data, drawn; and told to those who do not see it. */
export function ChartFace({ object, size }: { object: ObjectView; size: readonly [number, number] }) {
  const port = object.outputs[0]?.id ?? object.id;
  const output = useOutput(port);
  const page = useRows(port, 0, output && output.items > 0 ? MOST_ROWS : 0, output);
  const [width, height] = [Math.max(size[0] - 2 * EDGE, 1), Math.max(size[1] - 2 * EDGE, 1)];
  const name = object.nickname.trim() || object.name;
  const branches = page && branchesOf(page.rows);
  const { words, drawn } = (branches && draw(object, branches, [width, height], page)) ?? { words: [], drawn: null };
  if (words.length === 0) return <span className="no-picture">{t("canvas.empty")}</span>;
  const label = t("canvas.chart", { name, values: told(words) });
  return (
    <svg className="chart" style={{ left: EDGE, top: EDGE }} width={width} height={height} role="img" aria-label={label}>
      <title>{label}</title>
      <rect className="ground" width={width} height={height} />
      {drawn}
    </svg>
  );
}

function line(branches: string[][], room: Point) {
  const values = numbersOf(branches.flat());
  const points = lineOf(values, room);
  const drawn = <polyline className="curve" points={points.map((point) => point.join(",")).join(" ")} />;
  return { words: values.map(shortNumber), drawn };
}

/** A line for each value, from solution to solution, with what it is now. */
function tracks(history: History, room: Point) {
  const all = history.flat();
  const drawn = history.slice(0, MOST_TRACKS).map((values, place) => {
    const points = lineOf(values, room, all);
    const [x, y] = points.at(-1) ?? [0, 0];
    const now = values.at(-1);
    // A value that never changed is a line too.
    const line = points.length === 1 ? [...points, [room[0], y]] : points;
    return (
      <g key={place} className={`track stroke${place % COLOURS}`}>
        <polyline points={line.map((point) => point.join(",")).join(" ")} />
        <text x={Math.max(x, room[0]) - 2} y={Math.max(y - 2, 8)} textAnchor="end">
          {now === undefined ? "" : shortNumber(now)}
        </text>
      </g>
    );
  });
  return { words: history.map((values) => values.map(shortNumber).join(" → ")), drawn };
}

function bars(branches: string[][], room: Point) {
  const { bars, zero, labels } = barChart(branches.map(numbersOf), room);
  const drawn = (
    <>
      {bars.map(({ x, y, width, height, value, branch }, k) => (
        <rect key={k} className={`colour${branch % COLOURS}`} x={x} y={y} width={width} height={height}>
          <title>{shortNumber(value)}</title>
        </rect>
      ))}
      <line className="zero" x1={0} y1={zero} x2={room[0]} y2={zero} />
      {labels
        ? bars.map(({ x, y, width, height, value }, k) => (
            <text key={k} x={x + width / 2} y={value < 0 ? y + height + 8 : y - 2} textAnchor="middle">
              {shortNumber(value)}
            </text>
          ))
        : null}
    </>
  );
  return { words: bars.map(({ value }) => shortNumber(value)), drawn };
}

function pie(branches: string[][], [width, height]: Point) {
  const slices = slicesOf(partsOf(branches.flat()), 0.46 * Math.min(width, height));
  const percent = (share: number) => `${Math.round(share * 1000) / 10} %`;
  const drawn = (
    <g transform={`translate(${width / 2} ${height / 2})`}>
      {slices.map(({ name, share, path }, k) => (
        <path key={k} className={`slice colour${k % COLOURS}`} d={path}>
          <title>{`${name} (${percent(share)})`}</title>
        </path>
      ))}
      {slices.map(({ name, label }, k) =>
        label ? (
          <text key={k} className="on" x={label[0]} y={label[1] + 3} textAnchor="middle">
            {name.length > 12 ? `${name.slice(0, 11)}…` : name}
          </text>
        ) : null,
      )}
    </g>
  );
  return { words: slices.map(({ name, share }) => `${name} (${percent(share)})`), drawn };
}
