import { useMemo, useRef, useState } from "react";

import { t } from "../i18n";
import { cellText } from "./core/axes";
import { type Sort, sorted } from "./core/order";
import type { Derived } from "./derived";
import { look, set, useChosen } from "./store";

/** The height of a row in pixels, and of what is seen of the table. */
const ROW = 29;
const SEEN = 420;
/** So many rows before and after what is seen are there. */
const SPARE = 8;

/** The selected points as a table. Only the rows that are seen are in the page. */
export function Table({ study, places, good, onFront, front }: Derived) {
  const sort = useChosen((chosen) => chosen.sort);
  const current = useChosen((chosen) => chosen.point);
  const order = useMemo(() => sorted(places, study.rows, sort, onFront), [places, study.rows, sort, onFront]);
  const [top, setTop] = useState(0);
  const area = useRef<HTMLDivElement>(null);
  const first = Math.max(0, Math.min(order.length - 1, Math.floor(top / ROW) - SPARE));
  const last = Math.min(order.length, first + Math.ceil(SEEN / ROW) + 2 * SPARE);
  const hasFront = front.length > 0;
  const hasReasons = study.rows.some(({ reason }) => reason !== "");
  const width = 2 + study.columns.length + Number(hasFront) + Number(hasReasons);
  const head = { sort };
  return (
    <section className="panel points" aria-labelledby="table-title">
      <div className="panel-head"><h2 id="table-title">{t("study.table")}</h2><span className="soft">{t("study.selected", { count: places.length })}</span></div>
      <div className="table-area" ref={area} style={{ maxHeight: SEEN }} tabIndex={0} role="group" aria-labelledby="table-title" onScroll={(event) => setTop(event.currentTarget.scrollTop)}>
        <table aria-rowcount={order.length + 1}>
          <thead>
            <tr aria-rowindex={1}>
              <Head {...head} by="point" name={t("study.column.point")} />
              <Head {...head} by="status" name={t("study.column.status")} />
              {hasFront && <Head {...head} by="front" name={t("study.column.front")} />}
              {study.columns.map(({ name, kind }, at) => <Head key={`${kind}.${name}`} {...head} by={at} name={name} kind={t(`study.axis.${kind}`)} />)}
              {hasReasons && <th scope="col">{t("study.column.reason")}</th>}
            </tr>
          </thead>
          <tbody>
            {first > 0 && <tr aria-hidden="true" style={{ height: first * ROW }}><td colSpan={width} /></tr>}
            {order.slice(first, last).map((place, k) => {
              const row = study.rows[place];
              if (!row) return null;
              const isFailed = good[place] === 0;
              const kinds = [isFailed ? "failed" : "", onFront.has(place) ? "on-front" : "", row.point === current ? "current" : ""].join(" ");
              return (
                <tr key={`${row.point} ${place}`} className={kinds} aria-rowindex={first + k + 2} onClick={() => look(row.point)}>
                  <th scope="row">
                    <button type="button" className="quiet" aria-pressed={row.point === current} aria-label={t("study.point", { point: row.point })}
                      onClick={(event) => { event.stopPropagation(); look(row.point); }}>{row.point}</button>
                  </th>
                  <td className="outcome-word">{isFailed && <span aria-hidden="true">✕ </span>}{row.status}</td>
                  {hasFront && <td>{onFront.has(place) ? `◆ ${t("study.onFront")}` : ""}</td>}
                  {study.columns.map(({ name, kind, number }, at) => <td key={`${kind}.${name}`} className={number ? "number" : ""}>{cellText(row.cells[at])}</td>)}
                  {hasReasons && <td className="reason">{row.reason}</td>}
                </tr>
              );
            })}
            {last < order.length && <tr aria-hidden="true" style={{ height: (order.length - last) * ROW }}><td colSpan={width} /></tr>}
          </tbody>
        </table>
      </div>
      {order.length === 0 && <p className="soft">{t("study.table.none")}</p>}
    </section>
  );
}

/** The head of a column, which sorts by it. */
function Head({ sort, by, name, kind }: { sort: Sort; by: Sort["by"]; name: string; kind?: string }) {
  const isIt = sort.by === by;
  const sign = isIt ? (sort.descending ? "▼" : "▲") : "";
  return (
    <th scope="col" aria-sort={isIt ? (sort.descending ? "descending" : "ascending") : "none"}>
      <button type="button" className="quiet" onClick={() => set({ sort: { by, descending: isIt && !sort.descending } })}>
        {name} {kind && <span className="soft">{kind}</span>} <span aria-hidden="true">{sign}</span>
      </button>
    </th>
  );
}
