import { settingsStore, type SidePanel, type Theme } from "../app/settings";
import { register, type Action } from "./registry";

const side = (panel: SidePanel, keys: string[]): Action => ({
  id: `view.${panel}`,
  label: `side.${panel}`,
  group: "view",
  under: "menu.panels",
  keys,
  isOn: () => settingsStore.getState().side === panel,
  run: () => settingsStore.setState(({ side: now }) => ({ side: now === panel ? undefined : panel })),
});

const theme = (name: Theme): Action => ({
  id: `view.theme.${name}`,
  label: `theme.${name}`,
  group: "view",
  under: "menu.theme",
  isOn: () => settingsStore.getState().theme === name,
  run: () => settingsStore.setState({ theme: name }),
});

const panes = (shown: "both" | "canvas" | "viewport"): Action => ({
  id: `view.panes.${shown}`,
  label: `panes.${shown}`,
  group: "view",
  under: "menu.panels",
  isOn: () => settingsStore.getState().panes === shown,
  run: () => settingsStore.setState({ panes: shown }),
});

register(
  side("outline", ["Mod+Shift+O"]),
  side("problems", ["Mod+Shift+M"]),
  side("data", ["Mod+Shift+D"]),
  side("effects", ["Mod+Shift+Y"]),
  panes("both"),
  panes("canvas"),
  panes("viewport"),
  {
    id: "view.otherPane",
    label: "action.otherPane",
    group: "view",
    keys: ["V"],
    run() {
      const there = document.activeElement?.closest("#viewport") ? "canvas" : "viewport";
      document.getElementById(there)?.focus();
    },
  },
  theme("system"),
  theme("light"),
  theme("dark"),
);
