import { useEffect, type CSSProperties } from "react";
import { useStore } from "zustand";

import { followKeys } from "../actions/keys";
import { Canvas } from "../canvas";
import { Dialogs } from "../dialogs";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { pickStore } from "../state/pickJob";
import { join } from "../state/session";
import { ViewportPane } from "../viewport";
import { Banners } from "./Banners";
import { DropZone } from "./DropZone";
import { token } from "./files";
import { Header } from "./Header";
import { settingsStore } from "./settings";
import { SidePanel } from "./SidePanel";
import { Splitter } from "./Splitter";
import { Status } from "./Status";
import { Telling } from "./Telling";

/** A document with canvas and viewport side by side. */
export function Workbench({ id }: { id: string }) {
  const { panes, split, side } = useStore(settingsStore);
  const name = useStore(documentStore, (mirror) => mirror.document?.name);
  const changed = useStore(documentStore, (mirror) => mirror.document?.changed);
  useEffect(() => join(id, token()), [id]);
  useEffect(() => followKeys(), []);
  // Who is to pick sees what there is to pick from.
  useEffect(() => pickStore.subscribe(({ job }) => job && settingsStore.getState().panes === "canvas" && settingsStore.setState({ panes: "both" })), []);
  useEffect(() => {
    document.title = name ? `${changed ? "• " : ""}${name} – ${t("app.title")}` : t("app.title");
  }, [name, changed]);

  const share = (of: number) => `minmax(0, ${of}fr)`;
  const columns = panes === "both" ? [share(split), "6px", share(1 - split)] : [share(1)];
  if (side) columns.push("minmax(240px, 340px)");
  return (
    <div className="workbench">
      <a className="skip button" href="#canvas">
        {t("skip.canvas")}
      </a>
      <Header />
      <Banners />
      <main className="rooms" style={{ "--columns": columns.join(" ") } as CSSProperties}>
        {panes !== "viewport" && (
          <section id="canvas" className="room" data-scope="canvas" aria-label={t("room.canvas")} tabIndex={-1}>
            <Canvas />
          </section>
        )}
        {panes === "both" && <Splitter />}
        {panes !== "canvas" && (
          <section id="viewport" className="room" data-scope="viewport" aria-label={t("room.viewport")} tabIndex={-1}>
            <ViewportPane>
              <Telling />
            </ViewportPane>
          </section>
        )}
        {side && <SidePanel name={side} />}
      </main>
      <Status />
      <Dialogs />
      <DropZone document={id} />
    </div>
  );
}
