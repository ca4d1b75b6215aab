/** A drag of the pointer inside a control: from the press until it is let go, or until Escape. */

import type { PointerEvent as ReactPointerEvent } from "react";

export interface DragHandlers {
  /** Pixels since the press, and the event for its keys. */
  move(by: readonly [number, number], event: PointerEvent): void;
  end(moved: boolean): void;
  abandon(): void;
}

/** Follows the pointer after a press of the left button. The press goes no farther. */
export function follow(press: ReactPointerEvent<Element>, handlers: DragHandlers): void {
  if (press.button !== 0) return;
  press.stopPropagation();
  const element = press.currentTarget;
  const start = [press.clientX, press.clientY] as const;
  const id = press.pointerId;
  let strayed = false;
  element.setPointerCapture(id);

  const move = (event: PointerEvent) => {
    if (event.pointerId !== id) return;
    const by = [event.clientX - start[0], event.clientY - start[1]] as const;
    strayed ||= Math.hypot(...by) >= 2;
    if (strayed) handlers.move(by, event);
  };
  const stop = () => {
    element.removeEventListener("pointermove", move as EventListener);
    element.removeEventListener("pointerup", up as EventListener);
    element.removeEventListener("pointercancel", cancel);
    window.removeEventListener("keydown", key, true);
    if (element.hasPointerCapture(id)) element.releasePointerCapture(id);
  };
  const up = (event: PointerEvent) => {
    if (event.pointerId !== id) return;
    stop();
    handlers.end(strayed);
  };
  const cancel = () => {
    stop();
    handlers.abandon();
  };
  const key = (event: KeyboardEvent) => {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    cancel();
  };
  element.addEventListener("pointermove", move as EventListener);
  element.addEventListener("pointerup", up as EventListener);
  element.addEventListener("pointercancel", cancel);
  window.addEventListener("keydown", key, true);
}
