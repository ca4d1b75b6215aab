import { t } from "../i18n";
import { shown } from "./core/axes";
import type { Goal } from "./core/rows";
import type { Derived } from "./derived";
import { set } from "./store";

const wordOf = (goal: Goal | undefined) => (goal === undefined ? "none" : typeof goal === "string" ? goal : "near");

/** Which outputs are to be small or large, and the front that follows. */
export function Goals({ study, axes, goals, front }: Derived) {
  const outputs = axes.filter((axis) => axis.kind === "out" && !axis.words);
  if (outputs.length < 2) return null;
  const change = (key: string, word: string) => {
    const next = new Map(goals);
    if (word === "least" || word === "most") next.set(key, word);
    else if (word === "none") next.delete(key);
    set({ goals: next });
  };
  return (
    <section className="panel goals" aria-labelledby="front-title">
      <div className="panel-head">
        <h2 id="front-title">{t("study.front")}</h2>
        <span data-testid="front">{front.length > 0 && t("study.front.count", { count: front.length })}</span>
      </div>
      <p className="soft">{t("study.front.help")}</p>
      <div className="goal-list">
        {outputs.map(({ key, name }) => {
          const goal = goals.get(key);
          return (
            <label key={key} className="choice">
              <span>{name}</span>
              <select aria-label={t("study.goal.of", { name })} value={wordOf(goal)} onChange={(event) => change(key, event.target.value)}>
                <option value="none">{t("study.goal.none")}</option>
                <option value="least">{t("study.goal.least")}</option>
                <option value="most">{t("study.goal.most")}</option>
                {typeof goal === "object" && <option value="near">{t("study.goal.near", { number: shown(goal.near) })}</option>}
              </select>
            </label>
          );
        })}
      </div>
      {(study.bounds ?? []).map(({ output, bound }) => (
        <p key={`${output} ${JSON.stringify(bound)}`} className="soft">
          {"at-most" in bound
            ? t("study.bound.most", { name: output, number: shown(bound["at-most"]) })
            : t("study.bound.least", { name: output, number: shown(bound["at-least"]) })}
        </p>
      ))}
    </section>
  );
}
