import { engine } from "#engine";

import { goTo, linkOf } from "../app/files";
import { chooseToInsert } from "../app/insert";
import { chooseModel } from "../app/model";
import { place } from "../app/place";
import { forgetTemplate, keepTemplate, openNew, template } from "../app/template";
import { showDialog } from "../dialogs/store";
import { documentStore } from "../state/document";
import { modelStore } from "../state/model";
import { ask, lineStore } from "../state/session";
import { t } from "../i18n";
import { register } from "./registry";

const isOpen = () => documentStore.getState().document !== undefined;

register(
  {
    id: "file.new",
    label: "action.new",
    group: "file",
    keys: ["Mod+Alt+N"],
    run: async () => goTo(await openNew()),
  },
  { id: "file.start", label: "action.start", group: "file", keys: ["Mod+O"], run: () => goTo(undefined) },
  { id: "file.documents", label: "documents.action", group: "file", keys: ["Mod+Shift+K"], run: () => showDialog("documents") },
  { id: "file.model", label: "action.model", group: "file", isEnabled: isOpen, run: chooseModel },
  {
    id: "file.detach",
    label: "action.detach",
    group: "file",
    isEnabled: () => isOpen() && modelStore.getState().model !== undefined,
    async run() {
      await ask({ ask: "detachModel" });
    },
  },
  { id: "file.insert", label: "insert.action", group: "file", isEnabled: isOpen, run: chooseToInsert },
  {
    id: "file.save",
    label: "action.save",
    group: "file",
    keys: ["Mod+S"],
    isEnabled: isOpen,
    async run() {
      if (!documentStore.getState().document?.path) return showDialog("saveAs");
      // A refusal is shown in the line at the bottom.
      await ask({ ask: "save", path: null }).catch(() => undefined);
    },
  },
  {
    id: "file.saveAs",
    label: "action.saveAs",
    group: "file",
    keys: ["Mod+Shift+S"],
    isEnabled: isOpen,
    run: () => showDialog("saveAs"),
  },
  {
    id: "file.export",
    label: "action.export",
    group: "file",
    keys: ["Mod+Shift+E"],
    isEnabled: isOpen,
    run: () => showDialog("export"),
  },
  {
    id: "file.scripts",
    label: "action.scripts",
    group: "file",
    isEnabled: () => documentStore.getState().document?.scripts !== undefined,
    run: () => showDialog("scripts"),
  },
  {
    id: "file.player",
    label: "action.player",
    group: "file",
    isEnabled: isOpen,
    run: () => goTo(place(location.search).document, true),
  },
  ...(engine
    ? [
        {
          id: "file.link",
          label: "action.link" as const,
          group: "file" as const,
          isEnabled: isOpen,
          async run() {
            try {
              await navigator.clipboard.writeText(await linkOf(place(location.search).document ?? ""));
              lineStore.setState({ complaint: t("link.copied") });
            } catch (error) {
              lineStore.setState({ complaint: error instanceof Error ? error.message : String(error) });
            }
          },
        },
      ]
    : []),
  {
    id: "file.template",
    label: "action.template",
    group: "file",
    isEnabled: isOpen,
    run: () => keepTemplate(place(location.search).document ?? ""),
  },
  { id: "file.template.forget", label: "action.template.forget", group: "file", isEnabled: () => template() !== null, run: forgetTemplate },
  {
    id: "file.publish",
    label: "action.publish",
    group: "file",
    isEnabled: isOpen,
    run: () => showDialog("publish"),
  },
  {
    id: "file.settings",
    label: "action.settings",
    group: "file",
    keys: ["Mod+,"],
    isEnabled: isOpen,
    run: () => showDialog("settings"),
  },
);
