/** Which theme the page is in, for what is drawn on canvases. */

import { useSyncExternalStore } from "react";

import type { Theme } from "./core/colours";

function subscribe(tell: () => void): () => void {
  const watch = new MutationObserver(tell);
  watch.observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
  return () => watch.disconnect();
}

const current = (): Theme => (document.documentElement.dataset.theme === "dark" ? "dark" : "light");

export const useTheme = (): Theme => useSyncExternalStore(subscribe, current);

/** A colour of the page's, by the name of its variable. */
export const ink = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
