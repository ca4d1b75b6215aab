import { useEffect, useRef, useState } from "react";

import { t } from "../i18n";
import { fileAddress, openPoint } from "./api";
import { cellText } from "./core/axes";
import type { Row } from "./core/rows";
import type { Derived } from "./derived";
import { set, useChosen } from "./store";

/** The point that is looked at: its picture, its numbers, and the way into the studio. */
export function Detail({ study, places, onFront, good }: Derived) {
  const point = useChosen((chosen) => chosen.point);
  const place = point === undefined ? -1 : study.rows.findIndex((row) => row.point === point);
  const row = study.rows[place];
  const panel = useRef<HTMLElement>(null);
  useEffect(() => {
    // Beside the plots it is always seen; on a narrow page it stands above them.
    if (point !== undefined && matchMedia("(max-width: 760px)").matches) panel.current?.scrollIntoView({ block: "nearest" });
  }, [point]);
  if (!row) {
    return (
      <section className="panel detail" aria-labelledby="detail-title">
        <div className="panel-head"><h2 id="detail-title">{t("study.column.point")}</h2></div>
        <p className="soft">{t("study.point.none")}</p>
      </section>
    );
  }
  const at = places.indexOf(place);
  const step = (by: number) => {
    const next = study.rows[places[at < 0 ? 0 : (at + by + places.length) % places.length] ?? -1];
    if (next) set({ point: next.point });
  };
  const isFailed = good[place] === 0;
  return (
    <section ref={panel} className="panel detail open" aria-labelledby="detail-title">
      <div className="panel-head">
        <h2 id="detail-title">{t("study.point", { point: row.point })}</h2>
        <button type="button" className="quiet" onClick={() => step(-1)} aria-label={t("study.point.previous")} disabled={places.length < 2}>‹</button>
        <button type="button" className="quiet" onClick={() => step(1)} aria-label={t("study.point.next")} disabled={places.length < 2}>›</button>
        <button type="button" className="quiet" onClick={() => set({ point: undefined })} aria-label={t("study.point.close")}>✕</button>
      </div>
      {row.picture && <img className="large" src={fileAddress(row.picture)} alt={t("study.picture.of", { point: row.point })} />}
      <p className={isFailed ? "outcome failed" : "outcome"}>
        {isFailed && <span aria-hidden="true">✕ </span>}
        {row.status || t("study.status.none")}
        {onFront.has(place) && ` ◆ ${t("study.key.front")}`}
        {row.reason && <span className="reason">{row.reason}</span>}
      </p>
      <Numbers row={row} columns={study.columns} kind="in" title={t("study.point.inputs")} />
      <Numbers row={row} columns={study.columns} kind="out" title={t("study.point.outputs")} />
      {study.definition ? <Opening key={row.point} point={row.point} /> : <p className="soft">{t("study.point.noDefinition")}</p>}
      {row.geometry && <a href={`${fileAddress(row.geometry)}`} download>{t("study.point.geometry")}</a>}
    </section>
  );
}

function Numbers({ row, columns, kind, title }: { row: Row; columns: Derived["study"]["columns"]; kind: "in" | "out"; title: string }) {
  const shown = columns.map((column, at) => ({ ...column, at })).filter((column) => column.kind === kind);
  if (shown.length === 0) return null;
  return (
    <>
      <h3>{title}</h3>
      <dl>
        {shown.map(({ name, at }) => (
          <div key={at}><dt>{name}</dt><dd>{cellText(row.cells[at]) || t("study.noValue")}</dd></div>
        ))}
      </dl>
    </>
  );
}

/** Opens the definition with the values of a point, in a tab of its own. */
function Opening({ point }: { point: number }) {
  const [state, setState] = useState<{ is: "ready" | "busy" } | { is: "opened"; address: string } | { is: "failed"; why: string }>({ is: "ready" });
  const open = async () => {
    setState({ is: "busy" });
    try {
      const address = await openPoint(point);
      window.open(address, "_blank", "noopener");
      setState({ is: "opened", address });
    } catch (error) {
      setState({ is: "failed", why: error instanceof Error ? error.message : String(error) });
    }
  };
  return (
    <div className="opening">
      <button type="button" className="primary" disabled={state.is === "busy"} onClick={() => void open()}>{t("study.point.open")}</button>
      <div role="status">
        {state.is === "opened" && <>{t("study.point.opened")} <a href={state.address}>{t("study.point.link")}</a></>}
        {state.is === "failed" && <span className="failures">{state.why}</span>}
      </div>
    </div>
  );
}
