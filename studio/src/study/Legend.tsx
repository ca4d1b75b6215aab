import { t } from "../i18n";
import { type Axis, label, shown } from "./core/axes";
import { STEPS } from "./core/colours";

/** What the colours tell. */
export function Legend({ axis, colours }: { axis: Axis; colours: readonly string[] }) {
  const isFew = axis.words !== undefined && colours.length < STEPS;
  return (
    <div className="legend" role="group" aria-label={t("study.legend", { name: axis.name })}>
      <span className="legend-name">{axis.name}</span>
      {isFew ? (
        colours.map((colour, at) => (
          <span key={colour} className="legend-word">
            <span className="swatch" style={{ background: colour }} /> {label(axis, at)}
          </span>
        ))
      ) : (
        <>
          <span>{axis.words ? axis.words[0] : shown(axis.domain[0])}</span>
          <span className="ramp" style={{ background: `linear-gradient(to right, ${colours.join(", ")})` }} />
          <span>{axis.words ? axis.words[axis.words.length - 1] : shown(axis.domain[1])}</span>
        </>
      )}
    </div>
  );
}
