import type { KeyboardEvent, PointerEvent } from "react";
import { useStore } from "zustand";

import { t } from "../i18n";
import { settingsStore } from "./settings";

/** Between canvas and viewport: dragged, or moved with the arrow keys. */
export function Splitter() {
  const split = useStore(settingsStore, (settings) => settings.split);
  const put = (share: number) => settingsStore.setState({ split: Math.min(0.85, Math.max(0.15, share)) });
  const drag = (event: PointerEvent<HTMLDivElement>) => {
    if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
    const whole = event.currentTarget.parentElement?.getBoundingClientRect();
    if (whole) put((event.clientX - whole.left) / whole.width);
  };
  const press = (event: KeyboardEvent) => {
    const step = { ArrowLeft: -0.02, ArrowRight: 0.02 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    put(split + step);
  };
  return (
    <div
      className="splitter"
      role="separator"
      aria-orientation="vertical"
      aria-label={t("splitter.label")}
      aria-valuenow={Math.round(split * 100)}
      aria-valuemin={15}
      aria-valuemax={85}
      tabIndex={0}
      onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
      onPointerMove={drag}
      onKeyDown={press}
    />
  );
}
