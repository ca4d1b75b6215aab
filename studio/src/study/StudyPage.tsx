import { useEffect } from "react";

import { t } from "../i18n";
import type { Study } from "./core/rows";
import { useDerived } from "./derived";
import { Detail } from "./Detail";
import { Filters } from "./Filters";
import { Goals } from "./Goals";
import { Header } from "./Header";
import { Histogram } from "./Histogram";
import { follow } from "./live";
import { Parallel } from "./Parallel";
import { Pictures } from "./Pictures";
import { Scatter } from "./Scatter";
import { useChosen } from "./store";
import { Table } from "./Table";

/** The page on a study: everything shows the same selection. */
export function StudyPage() {
  useEffect(follow, []);
  const study = useChosen((chosen) => chosen.study);
  const lost = useChosen((chosen) => chosen.lost);
  const name = study?.name ?? "";
  useEffect(() => {
    if (name) document.title = t("study.title", { name });
  }, [name]);
  return (
    <>
      <Header study={study} />
      <main className="study">
        {lost && <p className="remark error" role="alert">{t("study.lost", { why: lost })}</p>}
        {study?.problem && <p className="remark error" role="alert">{t("study.problem", { why: study.problem })}</p>}
        {!study && !lost && <p className="remark">{t("study.wait")}</p>}
        {study && study.rows.length === 0 && <p className="remark">{t("study.empty")}</p>}
        {study && study.rows.length > 0 && <Views study={study} />}
      </main>
    </>
  );
}

function Views({ study }: { study: Study }) {
  const derived = useDerived(study);
  const hasPictures = study.rows.some(({ picture }) => picture !== "");
  return (
    <>
      <Filters {...derived} />
      <Parallel {...derived} />
      <div className="columns">
        <div className="plots">
          <Scatter {...derived} />
          <Histogram {...derived} />
          <Goals {...derived} />
        </div>
        <Detail {...derived} />
      </div>
      {hasPictures && <Pictures {...derived} />}
      <Table {...derived} />
    </>
  );
}
