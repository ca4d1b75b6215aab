import { useEffect, useState } from "react";
import { useStore } from "zustand";

import type { Page } from "../core/protocol/Page";
import { title } from "../core/outline";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { runStore } from "../state/run";
import { ask } from "../state/session";
import { uiStore } from "../state/ui";
import { inWords } from "./Outline";

/** As many rows are asked for at a time. */
const ROWS = 200;

/** The data of the selected object's ports, row by row. */
export function Data() {
  const id = useStore(uiStore, (ui) => (ui.selection.size === 1 ? [...ui.selection][0] : undefined));
  const object = useStore(documentStore, (mirror) => (id ? mirror.objects.get(id) : undefined));
  const [chosen, setChosen] = useState<string>();
  if (!object) return <p>{t("data.select")}</p>;
  const isOwnPort = object.outputs[0]?.id === object.id;
  const ports = isOwnPort ? object.outputs : [...object.outputs, ...object.inputs];
  const port = ports.find((one) => one.id === chosen) ?? ports[0];
  return (
    <>
      <h3>{title(object)}</h3>
      {ports.length > 1 && (
        <label>
          {t("data.port")}{" "}
          <select value={port?.id} onChange={(event) => setChosen(event.target.value)}>
            {ports.map((one) => (
              <option key={one.id} value={one.id}>
                {one.name}
              </option>
            ))}
          </select>
        </label>
      )}
      {port && <Rows key={port.id} port={port.id} />}
    </>
  );
}

function Rows({ port }: { port: string }) {
  const [page, setPage] = useState<Page>();
  const [from, setFrom] = useState(0);
  const solution = useStore(runStore, (run) => run.solution);
  const summary = useStore(runStore, (run) => run.outputs.get(port));
  const within = useStore(documentStore, (mirror) => mirror.within);
  useEffect(() => {
    let current = true;
    ask({ ask: "rows", port, from, count: ROWS, within }).then(
      (answer) => {
        if (current && answer.event === "rows") setPage(answer.page);
      },
      () => undefined,
    );
    return () => {
      current = false;
    };
  }, [port, from, solution, within]);
  if (!page) return null;
  return (
    <>
      {summary && <p className="soft">{inWords(summary)}</p>}
      <table className="data">
        <tbody>
          {page.rows.map((row, index) =>
            row.is === "path" ? (
              <tr key={index}>
                <th scope="rowgroup" colSpan={2}>
                  {row.path} <span className="soft">N = {row.items}</span>
                </th>
              </tr>
            ) : (
              <tr key={index}>
                <th scope="row">{row.index}</th>
                <td>{row.text}</td>
              </tr>
            ),
          )}
        </tbody>
      </table>
      {page.total > ROWS && (
        <div className="row">
          <button type="button" disabled={from === 0} onClick={() => setFrom(Math.max(0, from - ROWS))}>
            {t("data.before")}
          </button>
          <span>{t("data.rows", { from: page.from + 1, to: page.from + page.rows.length, total: page.total })}</span>
          <button type="button" disabled={from + ROWS >= page.total} onClick={() => setFrom(from + ROWS)}>
            {t("data.after")}
          </button>
        </div>
      )}
    </>
  );
}
