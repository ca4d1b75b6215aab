import { useEffect, useRef } from "react";

interface NumberFieldProps {
  start: string;
  label: string;
  /** The text, or nothing when it was given up. Called once. */
  onDone(text: string | undefined): void;
}

/** A field that opens in the place of a number: Enter takes what is typed, arithmetic too; Escape gives up. */
export function NumberField({ start, label, onDone }: NumberFieldProps) {
  const field = useRef<HTMLInputElement>(null);
  const done = useRef(false);
  useEffect(() => {
    field.current?.focus();
    field.current?.select();
  }, []);
  const finish = (text: string | undefined) => {
    if (done.current) return;
    done.current = true;
    onDone(text);
  };
  return (
    <input
      className="number-field"
      data-own
      aria-label={label}
      defaultValue={start}
      ref={field}
      onPointerDown={(event) => event.stopPropagation()}
      onBlur={(event) => finish(event.target.value)}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Enter") finish(event.currentTarget.value);
        if (event.key === "Escape") finish(undefined);
      }}
    />
  );
}
