/** How closely surfaces and curves are looked at. */

import { useStore } from "zustand";

import { t, type Key } from "../../i18n";
import { ANALYSES, settingsStore } from "../settings";
import { Check, Range } from "./fields";
import { Popover } from "./Popover";

const set = settingsStore.setState;

export function AnalysisSheet() {
  return (
    <Popover label={t("viewport.analysis")} icon="analysis">
      <Colours />
      <Lines />
    </Popover>
  );
}

function Colours() {
  const { analysis, stripes, across } = useStore(settingsStore);
  return (
    <fieldset>
      <legend>{t("viewport.analysis.colours")}</legend>
      {ANALYSES.map((name) => (
        <label className="viewport-check" key={name}>
          <input
            type="radio"
            name="viewport-analysis"
            checked={analysis === name}
            onChange={() => set({ analysis: name, range: undefined })}
          />
          {t(`viewport.analysis.${name}` as Key)}
        </label>
      ))}
      {analysis === "zebra" && (
        <>
          <Range label="viewport.analysis.stripes" value={stripes} most={40} onChange={(value) => set({ stripes: value })} />
          <Check label="viewport.analysis.across" checked={across} onChange={(on) => set({ across: on })} />
        </>
      )}
    </fieldset>
  );
}

function Lines() {
  const { ofAll, comb, combScale, combTeeth, combSurfaces, circle, circles, controls, isocurves, directions } = useStore(settingsStore);
  return (
    <fieldset>
      <legend>{t("viewport.analysis.of")}</legend>
      <label className="viewport-check">
        <input type="radio" name="viewport-of" checked={!ofAll} onChange={() => set({ ofAll: false })} />
        {t("viewport.analysis.ofSelected")}
      </label>
      <label className="viewport-check">
        <input type="radio" name="viewport-of" checked={ofAll} onChange={() => set({ ofAll: true })} />
        {t("viewport.analysis.ofAll")}
      </label>
      <hr />
      <Check label="viewport.analysis.comb" checked={comb} onChange={(on) => set({ comb: on })} />
      {comb && (
        <>
          <Range label="viewport.analysis.combScale" value={combScale} most={100} onChange={(value) => set({ combScale: value })} />
          <Range label="viewport.analysis.combTeeth" value={combTeeth} most={60} onChange={(value) => set({ combTeeth: value })} />
          <Check label="viewport.analysis.combSurfaces" checked={combSurfaces} onChange={(on) => set({ combSurfaces: on })} />
        </>
      )}
      <Check label="viewport.analysis.circle" checked={circle} onChange={(on) => set({ circle: on })} />
      <Range label="viewport.analysis.circles" value={circles} least={0} most={50} onChange={(value) => set({ circles: value })} />
      <Check label="viewport.analysis.controls" checked={controls} onChange={(on) => set({ controls: on })} />
      <Range label="viewport.analysis.isocurves" value={isocurves} least={0} most={20} onChange={(value) => set({ isocurves: value })} />
      <Check label="viewport.analysis.directions" checked={directions} onChange={(on) => set({ directions: on })} />
    </fieldset>
  );
}
