import { useEffect, useRef, useState, type ReactNode } from "react";
import { useStore } from "zustand";

import "../actions/viewport";
import { t, type Key } from "../i18n";
import { documentStore } from "../state/document";
import { pickStore } from "../state/pickJob";
import { openViewport } from "./pane/open";
import type { Options } from "./Viewport";
import { viewportStore } from "./settings";
import { CombLegend } from "./toolbar/CombLegend";
import { Legend } from "./toolbar/Legend";
import { PickBar } from "./toolbar/PickBar";
import { PlaceList } from "./toolbar/PlaceList";
import { Toolbar } from "./toolbar/Toolbar";
import "./viewport.css";

/**
 * The model of the document that is open, with its toolbar unless it is plain. It needs only the stores. The children stand
 * in a row above the picture and take their room from it: they cover nothing of the model.
 */
export function ViewportPane({ options, children, isPlain = false }: { options?: Options; children?: ReactNode; isPlain?: boolean }) {
  const host = useRef<HTMLDivElement>(null);
  const [hasGraphics, setGraphics] = useState(true);
  const isPicking = useStore(pickStore, ({ job }) => job !== undefined);
  useEffect(() => {
    if (!host.current) return;
    try {
      return openViewport(host.current, options);
    } catch {
      setGraphics(false);
      return;
    }
  }, [options]);
  return (
    <div className="viewport">
      {!isPlain && <Toolbar />}
      {!isPicking && children}
      <div className="viewport-stage">
        <div className="viewport-host" ref={host} hidden={!hasGraphics} />
        {!hasGraphics && <p className="viewport-notice">{t("viewport.noGraphics")}</p>}
        {isPicking && <PickBar />}
        <Legend />
        <div className="viewport-notes">
          <CombLegend />
          <PlaceList />
        </div>
        <Pointed />
        <Notice />
      </div>
    </div>
  );
}

/** What is under the pointer. */
function Pointed() {
  const pointed = useStore(viewportStore, (state) => state.pointed);
  const name = useStore(documentStore, (mirror) => {
    const object = pointed && mirror.objects.get(pointed.object);
    return object && (object.nickname || object.name);
  });
  if (!pointed || name === undefined) return null;
  const { path, index, x, y } = pointed;
  const style = { transform: `translate(${x + 14}px, ${y + 18}px)` };
  return (
    <div className="viewport-pointed" style={style} role="tooltip">
      {index < 0 ? name : t("viewport.tooltip", { object: name, path, index })}
    </div>
  );
}

function Notice() {
  const notice = useStore(viewportStore, (state) => state.notice);
  const all = useStore(viewportStore, (state) => state.texts.all);
  const shown = useStore(viewportStore, (state) => state.texts.shown);
  const text = notice ? t(notice as Key) : all > shown ? t("viewport.moreTexts", { shown, all }) : undefined;
  return (
    <p className="viewport-notice" role="status" hidden={!text}>
      {text}
    </p>
  );
}
