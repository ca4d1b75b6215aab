import { useStore } from "zustand";

import "./dialogs.css";

import { About } from "./About";
import { CanvasViews } from "./CanvasViews";
import { ComponentHelp } from "./ComponentHelp";
import { DocumentSettings } from "./DocumentSettings";
import { Documents } from "./Documents";
import { Export } from "./Export";
import { Insert } from "./Insert";
import { KeySheet } from "./KeySheet";
import { Palette } from "./Palette";
import { Publish } from "./Publish";
import { ScriptDialog } from "../script/ScriptDialog";
import { ScriptsDialog } from "../script/ScriptsDialog";
import { SaveAs } from "./SaveAs";
import { dialogStore } from "./store";

/** The dialog that is open, if any. */
export function Dialogs() {
  const open = useStore(dialogStore, (state) => state.open);
  switch (open) {
    case "palette":
      return <Palette />;
    case "keys":
      return <KeySheet />;
    case "settings":
      return <DocumentSettings />;
    case "saveAs":
      return <SaveAs />;
    case "export":
      return <Export />;
    case "about":
      return <About />;
    case "help":
      return <ComponentHelp />;
    case "views":
      return <CanvasViews />;
    case "documents":
      return <Documents />;
    case "publish":
      return <Publish />;
    case "script":
      return <ScriptDialog />;
    case "scripts":
      return <ScriptsDialog />;
    case "insert":
      return <Insert />;
    case undefined:
      return null;
  }
}
