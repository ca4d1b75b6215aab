/** How this person likes the page; kept in the browser, never sent anywhere. */

import { createStore } from "zustand/vanilla";

export type Theme = "system" | "light" | "dark";
export type SidePanel = "outline" | "problems" | "data" | "effects";

export interface Settings {
  theme: Theme;
  /** The share of the width that the canvas takes, 0.15 to 0.85. */
  split: number;
  /** Which of the two great panes are shown. */
  panes: "both" | "canvas" | "viewport";
  side: SidePanel | undefined;
}

const KEY = "katydid.settings";
const USUAL: Settings = { theme: "system", split: 0.58, panes: "both", side: undefined };

/** The stored settings with what is missing or makes no sense as usual. Exported for tests. */
export function readSettings(text: string | null): Settings {
  let found: Partial<Record<keyof Settings, unknown>>;
  try {
    found = JSON.parse(text ?? "{}") as Partial<Record<keyof Settings, unknown>>;
  } catch {
    found = {};
  }
  const one = <T>(value: unknown, of: readonly T[], usual: T): T => of.find((x) => x === value) ?? usual;
  const split = typeof found?.split === "number" ? found.split : USUAL.split;
  return {
    theme: one(found?.theme, ["system", "light", "dark"] as const, USUAL.theme),
    split: Math.min(0.85, Math.max(0.15, split)),
    panes: one(found?.panes, ["both", "canvas", "viewport"] as const, USUAL.panes),
    side: one<SidePanel | undefined>(found?.side, ["outline", "problems", "data", "effects"], undefined),
  };
}

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

export const settingsStore = createStore<Settings>(() => readSettings(typeof localStorage === "undefined" ? null : stored()));

settingsStore.subscribe((settings) => {
  try {
    localStorage.setItem(KEY, JSON.stringify(settings));
  } catch {
    // A browser that keeps nothing still works.
  }
});

/** Puts the theme on the page, now and whenever it or the system's changes. */
export function followTheme(): () => void {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const apply = () => {
    const { theme } = settingsStore.getState();
    const isDark = theme === "dark" || (theme === "system" && dark.matches);
    document.documentElement.dataset.theme = isDark ? "dark" : "light";
  };
  apply();
  dark.addEventListener("change", apply);
  const stop = settingsStore.subscribe(apply);
  return () => {
    stop();
    dark.removeEventListener("change", apply);
  };
}
