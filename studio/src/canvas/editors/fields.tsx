import { useId, useState, type ReactNode } from "react";

import { evaluate } from "../../core/arithmetic";
import { numberText } from "../../core/numbers";
import { t } from "../../i18n";
import { closeBoxes } from "../open";

/** A line of a form: what it is about, and the field. */
export function Line({ label, children }: { label: string; children(id: string): ReactNode }) {
  const id = useId();
  return (
    <div className="form-line">
      <label htmlFor={id}>{label}</label>
      {children(id)}
    </div>
  );
}

interface NumberLineProps {
  label: string;
  value: number;
  whole?: boolean;
  take(value: number): void;
}

/** A number, or a formula for one. What is neither stays in the field and is marked. */
export function NumberLine({ label, value, whole = false, take }: NumberLineProps) {
  const [text, setText] = useState<string | undefined>(undefined);
  const read = text === undefined ? value : evaluate(text.replace(",", "."), value);
  return (
    <Line label={label}>
      {(id) => (
        <input
          id={id}
          inputMode="decimal"
          value={text ?? numberText(value)}
          aria-invalid={read === undefined}
          onChange={(event) => {
            setText(event.target.value);
            const next = evaluate(event.target.value.replace(",", "."), value);
            if (next !== undefined) take(whole ? Math.round(next) : next);
          }}
          onBlur={() => setText(undefined)}
        />
      )}
    </Line>
  );
}

interface TextLineProps {
  label: string;
  value: string;
  take(value: string): void;
}

export function TextLine({ label, value, take }: TextLineProps) {
  return (
    <Line label={label}>
      {(id) => <input id={id} spellCheck={false} value={value} onChange={(event) => take(event.target.value)} />}
    </Line>
  );
}

export function SwitchLine({ label, on, take }: { label: string; on: boolean; take(on: boolean): void }) {
  return (
    <Line label={label}>
      {(id) => <input id={id} type="checkbox" checked={on} onChange={(event) => take(event.target.checked)} />}
    </Line>
  );
}

interface FormProps {
  title: string;
  children: ReactNode;
  /** Whether what is in the form can be taken. */
  valid?: boolean;
  onTake(): void;
}

/** A form whose whole content becomes one edit. */
export function Form({ title, children, valid = true, onTake }: FormProps) {
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        if (!valid) return;
        onTake();
        closeBoxes();
      }}
    >
      <h3>{title}</h3>
      {children}
      <div className="form-end">
        <button type="button" onClick={closeBoxes}>
          {t("canvas.form.cancel")}
        </button>
        <button type="submit" className="first" disabled={!valid}>
          {t("canvas.form.take")}
        </button>
      </div>
    </form>
  );
}
