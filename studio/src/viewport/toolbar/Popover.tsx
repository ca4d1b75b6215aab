import { useEffect, useId, useRef, useState, type ReactNode } from "react";

import { Icon, type IconName } from "./icons";

/** A button that opens a small sheet of settings below it; Escape and a press elsewhere close it. */
export function Popover({ label, icon, children }: { label: string; icon: IconName; children: ReactNode }) {
  const [isOpen, setOpen] = useState(false);
  const holder = useRef<HTMLDivElement>(null);
  const button = useRef<HTMLButtonElement>(null);
  const id = useId();
  useEffect(() => {
    if (!isOpen) return;
    const close = (event: Event) => {
      if (!holder.current?.contains(event.target as Node)) setOpen(false);
    };
    addEventListener("pointerdown", close, true);
    addEventListener("focusin", close);
    return () => {
      removeEventListener("pointerdown", close, true);
      removeEventListener("focusin", close);
    };
  }, [isOpen]);
  return (
    <div
      className="viewport-popover"
      ref={holder}
      onKeyDown={(event) => {
        if (event.key !== "Escape" || !isOpen) return;
        event.stopPropagation();
        setOpen(false);
        button.current?.focus();
      }}
    >
      <button
        ref={button}
        type="button"
        aria-label={label}
        title={label}
        aria-expanded={isOpen}
        aria-controls={isOpen ? id : undefined}
        onClick={() => setOpen(!isOpen)}
      >
        <Icon name={icon} />
      </button>
      {isOpen && (
        <div className="viewport-sheet" id={id} role="group" aria-label={label}>
          {children}
        </div>
      )}
    </div>
  );
}
