/** Asks for new points again and again while they may come. */

import { readRows } from "./api";
import { receive, set, store } from "./store";

/** How long it waits between two questions: while points are solved, and when they are. */
const SOON = 700;
const LATER = 3000;

/** Begins to ask; gives what ends it. A page that nobody looks at asks nothing. */
export function follow(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let isOver = false;
  const ask = async () => {
    const { study } = store.getState();
    try {
      receive(await readRows(study?.generation ?? 0, study?.rows.length ?? 0));
    } catch (error) {
      set({ lost: error instanceof Error ? error.message : String(error) });
    }
    const state = store.getState().study?.state;
    const wait = state === "running" || state === "empty" ? SOON : LATER;
    if (!isOver) timer = setTimeout(() => void next(), wait);
  };
  const next = async () => {
    if (!document.hidden) return ask();
    document.addEventListener("visibilitychange", () => void next(), { once: true });
  };
  void ask();
  return () => {
    isOver = true;
    clearTimeout(timer);
  };
}
