/** The fields of the toolbar's sheets. */

import { t, type Key } from "../../i18n";

export function Check({ label, checked, onChange }: { label: Key; checked: boolean; onChange: (on: boolean) => void }) {
  return (
    <label className="viewport-check">
      <input type="checkbox" checked={checked} onChange={({ target }) => onChange(target.checked)} />
      {t(label)}
    </label>
  );
}

/** A range of whole numbers, with the number beside its name. */
export function Range({ label, value, least = 1, most, onChange }: {
  label: Key;
  value: number;
  least?: number;
  most: number;
  onChange: (value: number) => void;
}) {
  return (
    <label className="viewport-range">
      <span>{t(label)}</span>
      <span className="viewport-value" aria-hidden="true">
        {value}
      </span>
      <input type="range" aria-label={t(label)} min={least} max={most} value={value} onChange={({ target }) => onChange(target.valueAsNumber)} />
    </label>
  );
}
