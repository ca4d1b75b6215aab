import { useStore } from "zustand";

import { shortNumber } from "../../core/falseColour";
import { unitSuffix } from "../../core/units";
import { t } from "../../i18n";
import { analysisStore } from "../../state/analysis";
import { documentStore } from "../../state/document";
import { settingsStore } from "../settings";

/** What combs mean in numbers, and what there was too much of to be drawn. */
export function CombLegend() {
  const isOn = useStore(settingsStore, (settings) => settings.comb);
  const comb = useStore(analysisStore, (found) => found.comb);
  const leftOut = useStore(analysisStore, (found) => found.leftOut);
  const units = useStore(documentStore, (mirror) => mirror.document?.units);
  if (!(isOn && comb) && leftOut.length === 0) return null;
  return (
    <section className="viewport-note" aria-label={t("viewport.comb")}>
      {isOn && comb && (
        <>
          <h2>{t("viewport.comb")}</h2>
          <p>{t("viewport.comb.sharpest", { value: shortNumber(comb.sharpest) + unitSuffix(units, -1) })}</p>
          <p>{t("viewport.comb.radius", { value: shortNumber(1 / comb.sharpest) + unitSuffix(units, 1) })}</p>
          <p>{t("viewport.comb.scale", { value: shortNumber(comb.scale) })}</p>
        </>
      )}
      {leftOut.map((text) => (
        <p key={text}>{text}</p>
      ))}
    </section>
  );
}
