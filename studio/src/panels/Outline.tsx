import { useDeferredValue, useMemo, useState } from "react";
import { useStore } from "zustand";

import { outline, type OutlineRow } from "../core/outline";
import type { OutputView } from "../core/protocol/OutputView";
import { t, type Key } from "../i18n";
import { documentStore } from "../state/document";
import { runStore } from "../state/run";
import { select, uiStore } from "../state/ui";

/** As many rows are drawn; the search narrows them down. */
const MOST = 400;

/** The definition as a list that can be read aloud: what each object reads and gives. */
export function Outline() {
  const objects = useStore(documentStore, (mirror) => mirror.objects);
  const order = useStore(documentStore, (mirror) => mirror.order);
  const results = useDeferredValue(useStore(runStore, (run) => run.results));
  const selection = useStore(uiStore, (ui) => ui.selection);
  const [search, setSearch] = useState("");
  const rows = useMemo(() => outline(objects, order, results), [objects, order, results]);
  const wanted = search.trim().toLowerCase();
  const found = wanted === "" ? rows : rows.filter((row) => row.title.toLowerCase().includes(wanted));
  return (
    <>
      <input
        type="search"
        value={search}
        aria-label={t("outline.search")}
        placeholder={t("outline.search")}
        onChange={(event) => setSearch(event.target.value)}
      />
      <p role="status" className="soft">
        {t("outline.count", { n: found.length })}
      </p>
      <ol className="outline">
        {found.slice(0, MOST).map((row) => (
          <Row key={row.id} row={row} selected={selection.has(row.id)} />
        ))}
      </ol>
      {found.length > MOST && <p className="soft">{t("outline.more", { n: found.length - MOST })}</p>}
    </>
  );
}

function Row({ row, selected }: { row: OutlineRow; selected: boolean }) {
  return (
    <li>
      <button type="button" aria-pressed={selected} onClick={() => select([row.id])}>
        {row.title}
        {row.status !== "" && row.status !== "ok" && <span className={`state ${row.status}`}> {t(`state.${row.status}` as Key)}</span>}
      </button>
      {row.reads.map(({ input, from }) => (
        <div key={input}>
          {t(input === "" ? "outline.readsOwn" : "outline.reads", { input, from: from.join(", ") })}
        </div>
      ))}
      {row.gives.map(({ output, data }) => data && <div key={output}>{t("outline.gives", { output, data: inWords(data) })}</div>)}
    </li>
  );
}

/** The data of an output in few words. */
export function inWords({ structure, branches, items }: OutputView): string {
  if (structure === "empty") return t("data.empty");
  if (structure === "item") return t("data.item");
  return structure === "list" ? t("data.list", { items }) : t("data.tree", { items, branches });
}
