/** Which dialog is open. One at a time. */

import { createStore } from "zustand/vanilla";

export type DialogName = "palette" | "keys" | "settings" | "saveAs" | "export" | "about" | "insert" | "documents" | "help" | "views" | "publish" | "script" | "scripts";

interface Dialogs {
  open: DialogName | undefined;
  /** The component that the help window is about. */
  component: string | undefined;
  /** The object whose script is edited. */
  object: string | undefined;
}

export const dialogStore = createStore<Dialogs>(() => ({ open: undefined, component: undefined, object: undefined }));

export function showDialog(open: DialogName | undefined): void {
  dialogStore.setState({ open });
}

/** Opens the help window on a component type. */
export function showHelp(component: string): void {
  dialogStore.setState({ open: "help", component });
}

/** Opens the editor of a script component. */
export function showScript(object: string): void {
  dialogStore.setState({ open: "script", object });
}
