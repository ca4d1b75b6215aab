import { useEffect, useMemo, useState } from "react";
import { useStore } from "zustand";

import { followKeys } from "../actions/keys";
import { goTo, linkOf, token } from "../app/files";
import { Telling } from "../app/Telling";
import type { ObjectView } from "../core/protocol/ObjectView";
import { Dialogs } from "../dialogs";
import { showDialog } from "../dialogs/store";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { runStore } from "../state/run";
import { join, lineStore } from "../state/session";
import { ViewportPane } from "../viewport";
import { inputGroups } from "./groups";
import { Input } from "./Input";
import { moved, reset, startOf, type Start } from "./reset";
import "./player.css";

/** How the inputs stood when they came. */
function useStart(inputs: readonly ObjectView[]): Start | undefined {
  const [start, setStart] = useState<Start>();
  useEffect(() => {
    if (inputs.length > 0) setStart((known) => known ?? startOf(inputs));
  }, [inputs]);
  return start;
}

/** Gives the address away: by what the system shares with, where it has that, else to the clipboard. */
async function share(id: string, told: (done: boolean) => void): Promise<void> {
  try {
    const url = await linkOf(id);
    if (navigator.share) await navigator.share({ title: document.title, url });
    else {
      await navigator.clipboard.writeText(url);
      told(true);
    }
  } catch (error) {
    // Who thinks better of it shares nothing; what is too large for a link is told.
    if (error instanceof RangeError) lineStore.setState({ complaint: error.message });
  }
}

/** Only the inputs and the model: for a phone, or a meeting with a client. */
export function Player({ id }: { id: string }) {
  const objects = useStore(documentStore, (mirror) => mirror.objects);
  const name = useStore(documentStore, (mirror) => mirror.document?.name);
  const state = useStore(lineStore, (line) => line.state);
  const solving = useStore(runStore, (run) => run.progress !== undefined);
  const published = useStore(documentStore, (mirror) => mirror.document?.player ?? null);
  const groups = useMemo(() => inputGroups(objects, published), [objects, published]);
  const inputs = useMemo(() => groups.flatMap((group) => group.inputs.map(({ object }) => object)), [groups]);
  const start = useStart(inputs);
  const changes = start ? moved(start, inputs) : [];
  const [shared, setShared] = useState(false);
  useEffect(() => join(id, token()), [id]);
  useEffect(() => followKeys(), []);
  useEffect(() => {
    document.title = name ?? t("app.title");
  }, [name]);
  return (
    <div className="player">
      <main className="model" data-scope="viewport" aria-label={t("room.viewport")}>
        <ViewportPane>
          <Telling />
        </ViewportPane>
      </main>
      <aside aria-label={t("player.inputs")}>
        <header>
          <h1>{name || t("document.unnamed")}</h1>
          <button type="button" className="quiet" onClick={() => goTo(id)}>
            {t("player.edit")}
          </button>
        </header>
        <p role="status" className="soft">
          {state === "lost" ? t("line.lost") : solving ? t("player.solving") : shared ? t("player.shared") : ""}
        </p>
        {groups.map(({ label, inputs: own }) => (
          <fieldset key={own[0]?.object.id}>
            {label && <legend>{label}</legend>}
            {own.map((input) => (
              <Input key={input.object.id} input={input} />
            ))}
          </fieldset>
        ))}
        {inputs.length === 0 && <p>{t("player.none")}</p>}
        <footer>
          <button type="button" disabled={changes.length === 0} onClick={() => reset(changes)}>
            {t("player.reset")}
          </button>
          <button type="button" onClick={() => void share(id, setShared)}>
            {t("player.share")}
          </button>
          <button type="button" className="primary" onClick={() => showDialog("export")}>
            {t("player.export")}
          </button>
        </footer>
      </aside>
      <Dialogs />
    </div>
  );
}
