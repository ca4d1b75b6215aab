import { useState, type FormEvent } from "react";
import { useStore } from "zustand";

import type { DocumentView } from "../core/protocol/DocumentView";
import { fromHex, toHex } from "../core/colour";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { edit } from "../state/session";
import { Dialog } from "./Dialog";
import { showDialog } from "./store";

/** The units that Rhino has names for; others are kept as they are. */
const UNITS = ["None", "Microns", "Millimeters", "Centimeters", "Meters", "Kilometers", "Inches", "Feet", "Yards", "Miles"];

/** Units, tolerances, preview colours, and who made the definition and what for. */
export function DocumentSettings() {
  const document = useStore(documentStore, (mirror) => mirror.document);
  return document ? <Form document={document} /> : null;
}

function Form({ document }: { document: DocumentView }) {
  const [form, setForm] = useState(document);
  const tolerance = Number(form.tolerance);
  const angle = Number(form.angleTolerance);
  const wrong = !(tolerance > 0) || !(angle > 0 && angle <= 90);
  const put = (change: Partial<DocumentView>) => setForm({ ...form, ...change });

  const submit = async (event: FormEvent) => {
    event.preventDefault();
    if (wrong) return;
    await edit({
      do: "settings",
      units: form.units,
      tolerance,
      angleTolerance: angle,
      previewNormal: form.previewNormal,
      previewSelected: form.previewSelected,
      name: form.name,
      author: form.author,
      description: form.description,
    });
    showDialog(undefined);
  };
  const units = UNITS.includes(form.units) ? UNITS : [form.units, ...UNITS];
  const colour = (label: string, key: "previewNormal" | "previewSelected") => (
    <label>
      {label}
      <span className="row">
        <input type="color" value={toHex(form[key])} onChange={(e) => put({ [key]: fromHex(e.target.value, form[key][3]) })} />
        <input
          type="range"
          min={0}
          max={255}
          value={form[key][3]}
          aria-label={t("settings.opacity", { of: label })}
          onChange={(e) => {
            const [r, g, b] = form[key];
            put({ [key]: [r, g, b, Number(e.target.value)] });
          }}
        />
      </span>
    </label>
  );
  return (
    <Dialog title={t("settings.title")}>
      <form onSubmit={(event) => void submit(event)}>
        <label>
          {t("settings.units")}
          <select value={form.units} onChange={(e) => put({ units: e.target.value })}>
            {units.map((unit) => (
              <option key={unit}>{unit}</option>
            ))}
          </select>
        </label>
        <label>
          {t("settings.tolerance")}
          <input type="number" step="any" min="0" value={form.tolerance} onChange={(e) => put({ tolerance: e.target.valueAsNumber })} />
        </label>
        <label>
          {t("settings.angle")}
          <input
            type="number"
            step="any"
            min="0"
            max="90"
            value={form.angleTolerance}
            onChange={(e) => put({ angleTolerance: e.target.valueAsNumber })}
          />
        </label>
        {colour(t("settings.normal"), "previewNormal")}
        {colour(t("settings.selected"), "previewSelected")}
        <label>
          {t("settings.name")}
          <input type="text" value={form.name} onChange={(e) => put({ name: e.target.value })} />
        </label>
        <label>
          {t("settings.author")}
          <input type="text" value={form.author} onChange={(e) => put({ author: e.target.value })} />
        </label>
        <label>
          {t("settings.description")}
          <textarea rows={3} value={form.description} onChange={(e) => put({ description: e.target.value })} />
        </label>
        {wrong && <p role="alert">{t("settings.wrong")}</p>}
        <footer>
          <button type="button" onClick={() => showDialog(undefined)}>
            {t("dialog.cancel")}
          </button>
          <button type="submit" className="primary" disabled={wrong}>
            {t("dialog.apply")}
          </button>
        </footer>
      </form>
    </Dialog>
  );
}
