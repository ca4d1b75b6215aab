import { useEffect, useState } from "react";
import { useStore } from "zustand";

import { colourAt, shortNumber } from "../../core/falseColour";
import { unitSuffix } from "../../core/units";
import { t, type Key } from "../../i18n";
import { documentStore } from "../../state/document";
import { settingsStore, viewportStore } from "../settings";

const STOPS = Array.from({ length: 9 }, (_, at) => `rgb(${colourAt(1 - at / 8).slice(0, 3).join(" ")})`).join(", ");
const TICKS = [1, 0.75, 0.5, 0.25, 0];

/** What the false colours mean, and the range they run over, which can be typed. */
export function Legend() {
  const analysis = useStore(settingsStore, (settings) => settings.analysis);
  const typed = useStore(settingsStore, (settings) => settings.range);
  const legend = useStore(viewportStore, (state) => state.legend);
  const units = useStore(documentStore, (mirror) => mirror.document?.units);
  if (analysis === "none" || analysis === "zebra") return null;
  const what = t(`viewport.analysis.${analysis}` as Key);
  const range = typed ?? legend?.range;
  if (!range) return <p className="viewport-legend">{t("viewport.legend.none")}</p>;
  const [least, greatest] = range;
  const set = (next: readonly [number, number]) => settingsStore.setState({ range: next });
  return (
    <section className="viewport-legend" aria-label={t("viewport.legend", { what })}>
      <h2>{what + unitSuffix(units, analysis === "gaussian" ? -2 : -1).replace(" ", ", ")}</h2>
      <Bound label="viewport.legend.greatest" value={greatest} onChange={(value) => set([Math.min(least, value), value])} />
      <div className="viewport-scale">
        <div className="viewport-ramp" style={{ background: `linear-gradient(${STOPS})` }} />
        <ol>
          {TICKS.map((place) => (
            <li key={place}>{shortNumber(least + (greatest - least) * place)}</li>
          ))}
        </ol>
      </div>
      <Bound label="viewport.legend.least" value={least} onChange={(value) => set([value, Math.max(greatest, value)])} />
      <button type="button" disabled={!typed} onClick={() => settingsStore.setState({ range: undefined })}>
        {t("viewport.legend.fit")}
      </button>
      <p>{t(legend?.exact ? "viewport.legend.exact" : "viewport.legend.estimated")}</p>
    </section>
  );
}

function Bound({ label, value, onChange }: { label: Key; value: number; onChange: (value: number) => void }) {
  const [text, setText] = useState(shortNumber(value));
  useEffect(() => setText(shortNumber(value)), [value]);
  const take = () => {
    const number = Number(text.replace(",", "."));
    if (text.trim() !== "" && Number.isFinite(number)) {
      if (text !== shortNumber(value)) onChange(number);
    } else {
      setText(shortNumber(value));
    }
  };
  return (
    <input
      type="text"
      inputMode="decimal"
      aria-label={t(label)}
      title={t(label)}
      value={text}
      onChange={({ target }) => setText(target.value)}
      onBlur={take}
      onKeyDown={({ key }) => key === "Enter" && take()}
    />
  );
}
