import { useEffect, useMemo } from "react";
import { useStore } from "zustand";

import { followKeys } from "../actions/keys";
import { goTo, token } from "../app/files";
import { Telling } from "../app/Telling";
import { Dialogs } from "../dialogs";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { runStore } from "../state/run";
import { join, lineStore } from "../state/session";
import { ViewportPane } from "../viewport";
import { Input, playable } from "./Input";
import "./player.css";

/** Only the inputs and the model: for a phone, or a meeting with a client. */
export function Player({ id }: { id: string }) {
  const objects = useStore(documentStore, (mirror) => mirror.objects);
  const name = useStore(documentStore, (mirror) => mirror.document?.name);
  const state = useStore(lineStore, (line) => line.state);
  const solving = useStore(runStore, (run) => run.progress !== undefined);
  const inputs = useMemo(() => playable([...objects.values()]), [objects]);
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
          <button type="button" onClick={() => goTo(id)}>
            {t("player.edit")}
          </button>
        </header>
        <p role="status" className="soft">
          {state === "lost" ? t("line.lost") : solving ? t("player.solving") : ""}
        </p>
        {inputs.map((object) => (
          <Input key={object.id} object={object} />
        ))}
        {inputs.length === 0 && <p>{t("player.none")}</p>}
      </aside>
      <Dialogs />
    </div>
  );
}
