import { useEffect } from "react";

import "./tokens.css";
import "./app.css";
import "../actions";
import { Player } from "../player/Player";
import { StartPage } from "../start/StartPage";
import { openLink } from "./files";
import { place } from "./place";
import { followTheme } from "./settings";
import { lineStore } from "../state/session";
import { Workbench } from "./Workbench";

/** The page: the start, a document on the workbench, or a document in the player. */
export function App() {
  useEffect(() => followTheme(), []);
  useEffect(() => {
    openLink().catch((error: unknown) => {
      lineStore.setState({ complaint: error instanceof Error ? error.message : String(error) });
    });
  }, []);
  const { document, player } = place(location.search);
  if (!document) return <StartPage />;
  return player ? <Player id={document} /> : <Workbench id={document} />;
}
