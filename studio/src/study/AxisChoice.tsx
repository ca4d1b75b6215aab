import type { ReactNode } from "react";

import { t } from "../i18n";
import type { Axis } from "./core/axes";

interface Props {
  label: string;
  axes: readonly Axis[];
  value: string;
  onChange: (key: string) => void;
  children?: ReactNode;
}

/** A list of all axes to choose one from; inputs and outputs stand apart. */
export function AxisChoice({ label, axes, value, onChange, children }: Props) {
  return (
    <label className="choice">
      <span>{label}</span>
      <select value={value} onChange={(event) => onChange(event.target.value)}>
        {children}
        {(["in", "out", "status"] as const).map((kind) => {
          const found = axes.filter((axis) => axis.kind === kind);
          return (
            found.length > 0 && (
              <optgroup key={kind} label={t(`study.axis.${kind}`)}>
                {found.map((axis) => <option key={axis.key} value={axis.key}>{axis.name}</option>)}
              </optgroup>
            )
          );
        })}
      </select>
    </label>
  );
}
