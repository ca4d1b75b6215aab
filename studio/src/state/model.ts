/** The Rhino model that was given to the document in this browser: the session knows its objects, not its name. */

import { createStore } from "zustand/vanilla";

export const modelStore = createStore<{ name: string | undefined }>(() => ({ name: undefined }));

const key = (document: string) => `katydid.model.${document}`;

export function rememberModel(document: string, name: string): void {
  modelStore.setState({ name });
  try {
    sessionStorage.setItem(key(document), name);
  } catch {
    // It is known until the page is loaded again.
  }
}

/** Takes up what was given to a document before the page was loaded again. */
export function recallModel(document: string): void {
  let name: string | null = null;
  try {
    name = sessionStorage.getItem(key(document));
  } catch {
    // Storage is forbidden: nothing was kept.
  }
  modelStore.setState({ name: name ?? undefined });
}
