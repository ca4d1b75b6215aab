import { useEffect, useId, useRef, type ReactNode } from "react";

import { showDialog } from "./store";

interface DialogProps {
  title: string;
  children: ReactNode;
  wide?: boolean;
  className?: string;
  /** What is done before it closes, however that comes about. */
  onClosing?(): void;
}

/** A modal dialog: the browser's own, which keeps the focus inside, closes on Escape and gives the focus back. */
export function Dialog({ title, children, wide = false, className, onClosing }: DialogProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  const id = useId();
  useEffect(() => {
    const element = dialog.current;
    if (element && !element.open) element.showModal();
  }, []);
  const close = () => {
    onClosing?.();
    dialog.current?.close();
    showDialog(undefined);
  };
  return (
    <dialog
      ref={dialog}
      className={[wide ? "wide" : "", className ?? ""].join(" ").trim() || undefined}
      aria-labelledby={id}
      // A long dialog is scrolled with the arrow keys: it takes the focus itself then.
      tabIndex={wide ? 0 : undefined}
      // The browser tells of the end later, when the next key may have opened another dialog.
      onCancel={(event) => {
        if (event.target !== dialog.current) return;
        event.preventDefault();
        close();
      }}
      onClose={() => showDialog(undefined)}
      onClick={(event) => event.target === dialog.current && close()}
    >
      <h2 id={id}>{title}</h2>
      {children}
    </dialog>
  );
}
