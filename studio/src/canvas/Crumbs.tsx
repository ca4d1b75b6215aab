import { useEffect } from "react";
import { useStore } from "zustand";

import { t } from "../i18n";
import { documentStore, type DocumentMirror } from "../state/document";
import { enter } from "./edits";

/** The names of clusters, kept when they are seen: from inside a cluster the session does not tell them. */
const names = new Map<string, string>();

function note({ objects }: DocumentMirror): void {
  for (const object of objects.values()) {
    if (object.kind === "cluster") names.set(object.id, object.nickname.trim() || object.name);
  }
}

/** The way from the document into the cluster that is shown, and back. */
export function Crumbs() {
  const within = useStore(documentStore, (mirror) => mirror.within);
  const document = useStore(documentStore, (mirror) => mirror.document?.name ?? "");
  useEffect(() => {
    note(documentStore.getState());
    return documentStore.subscribe((now, before) => now.objects !== before.objects && note(now));
  }, []);
  if (within.length === 0) return null;
  return (
    <nav className="crumbs" aria-label={t("canvas.crumbs")}>
      <button type="button" onClick={() => void enter([])}>
        {document || t("canvas.crumbs.document")}
      </button>
      {within.map((id, k) => (
        <span key={id}>
          <span aria-hidden="true"> › </span>
          <button
            type="button"
            aria-current={k === within.length - 1 ? "page" : undefined}
            disabled={k === within.length - 1}
            onClick={() => void enter(within.slice(0, k + 1))}
          >
            {names.get(id) ?? t("canvas.cluster")}
          </button>
        </span>
      ))}
    </nav>
  );
}
