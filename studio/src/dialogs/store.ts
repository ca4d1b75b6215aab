/** Which dialog is open. One at a time. */

import { createStore } from "zustand/vanilla";

export type DialogName = "palette" | "keys" | "settings" | "saveAs" | "export" | "about";

export const dialogStore = createStore<{ open: DialogName | undefined }>(() => ({ open: undefined }));

export function showDialog(open: DialogName | undefined): void {
  dialogStore.setState({ open });
}
