import { t } from "../i18n";
import { type Axis, shown } from "./core/axes";
import type { Range } from "./core/brushes";
import type { Derived } from "./derived";
import { brush, clearBrushes, useChosen } from "./store";

/** The range of a brush in words. */
export function rangeText(axis: Axis, [low, high]: Range): string {
  if (!axis.words) return t("study.filter.range", { low: shown(low), high: shown(high) });
  return axis.words.slice(Math.ceil(low), Math.floor(high) + 1).join(", ");
}

/** The brushes as a list, each with a button that takes it away. */
export function Filters({ axes, places, front }: Derived) {
  const brushes = useChosen((chosen) => chosen.brushes);
  const active = axes.flatMap((axis) => {
    const range = brushes.get(axis.key);
    return range ? [{ axis, range }] : [];
  });
  return (
    <section className="filters" aria-label={t("study.filters")}>
      <span className="selected-count" data-testid="selected">
        {t("study.selected", { count: places.length })}
        {front.length > 0 && `, ${t("study.front.count", { count: front.length })}`}
      </span>
      {active.length === 0 && <span className="soft">{t("study.filters.none")}</span>}
      {active.map(({ axis, range }) => (
        <button key={axis.key} type="button" className="chip" onClick={() => brush(axis, undefined)} aria-label={`${t("study.filter.remove", { name: axis.name })}: ${rangeText(axis, range)}`}>
          {axis.name} {rangeText(axis, range)} <span aria-hidden="true">✕</span>
        </button>
      ))}
      {active.length > 1 && <button type="button" onClick={clearBrushes}>{t("study.filters.clear")}</button>}
    </section>
  );
}

