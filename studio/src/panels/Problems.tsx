import { useStore } from "zustand";

import { emptyInputs, isStarved, lookOf } from "../core/look";
import { title } from "../core/outline";
import type { ObjectView } from "../core/protocol/ObjectView";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { runStore, type Run } from "../state/run";
import { select } from "../state/ui";

const LEVELS = ["error", "warning", "remark"];
const MOST = 300;

/** What is wrong, the worst first: with the file, and with each object. */
export function Problems() {
  const { objects, problems } = useStore(documentStore);
  const results = useStore(runStore, (run) => run.results);
  const missing = [...objects.values()].filter((object) => object.support.is === "no");
  const told = [...results.values()].flatMap(({ id, messages }) => messages.map((message) => ({ id, ...message })));
  const sorted = told
    .filter(({ id }) => objects.get(id)?.support.is === "yes")
    .sort((a, b) => LEVELS.indexOf(a.level) - LEVELS.indexOf(b.level));
  const outputs = useStore(runStore, (run) => run.outputs);
  const spoken = new Set(told.map(({ id }) => id));
  const silent = [...objects.values()].filter(
    (object) => !spoken.has(object.id) && lookOf(object, results.get(object.id), isStarved(object, outputs)) === "empty",
  );
  if (missing.length + sorted.length + problems.length + silent.length === 0) return <p>{t("problems.none")}</p>;
  return (
    <>
      {problems.length > 0 && (
        <section>
          <h3>{t("problems.file")}</h3>
          <ul>
            {problems.slice(0, MOST).map(({ text, object }, index) => (
              <li key={index}>{object ? <Go id={object}>{text}</Go> : text}</li>
            ))}
          </ul>
        </section>
      )}
      {missing.length > 0 && (
        <section>
          <h3>{t("problems.missing", { n: missing.length })}</h3>
          <p className="soft">{t("problems.kept")}</p>
          <ul>
            {missing.slice(0, MOST).map((object) => (
              <li key={object.id}>
                <Go id={object.id}>{title(object)}</Go>{" "}
                {object.support.is === "no" && (
                  <span className="soft">
                    {object.support.plugin ? `${object.support.plugin}: ` : ""}
                    {object.support.reason}
                  </span>
                )}
              </li>
            ))}
          </ul>
        </section>
      )}
      {sorted.length > 0 && (
        <section>
          <h3>{t("problems.solving", { n: sorted.length })}</h3>
          <ul>
            {sorted.slice(0, MOST).map(({ id, level, text }, index) => {
              const object = objects.get(id);
              return (
                <li key={index} className={level}>
                  <strong>{t(level === "error" ? "level.error" : level === "warning" ? "level.warning" : "level.remark")}</strong>{" "}
                  {object && <Go id={id}>{title(object)}</Go>}: {text}
                </li>
              );
            })}
          </ul>
        </section>
      )}
      {silent.length > 0 && (
        <section>
          <h3>{t("problems.empty", { n: silent.length })}</h3>
          <ul>
            {silent.slice(0, MOST).map((object) => (
              <li key={object.id} className="warning">
                <Go id={object.id}>{title(object)}</Go>: {t("problems.lacks", { inputs: lacking(object, outputs) })}
              </li>
            ))}
          </ul>
        </section>
      )}
    </>
  );
}

/** The inputs that an object waits for. */
function lacking(object: ObjectView, outputs: Run["outputs"]): string {
  const names = emptyInputs(object, outputs).map((port) => port.name || port.nickname);
  return (names.length > 0 ? names : [object.name]).join(", ");
}

function Go({ id, children }: { id: string; children: React.ReactNode }) {
  return (
    <button type="button" className="link" onClick={() => select([id])}>
      {children}
    </button>
  );
}
