import type { ReactNode } from "react";
import { useStore } from "zustand";

import { action } from "../actions/registry";
import { modelNeeds, whyNothing, type ModelNeeds, type Nothing } from "../core/needs";
import { t, type Key } from "../i18n";
import { documentStore } from "../state/document";
import { modelStore } from "../state/model";
import { runStore } from "../state/run";
import { edit } from "../state/session";
import { settingsStore as viewportSettings, viewportStore } from "../viewport/settings";
import { settingsStore } from "./settings";

/** What the viewport says where it cannot show what one expects, with the way out. */
export function Telling() {
  const objects = useStore(documentStore, (mirror) => mirror.objects);
  const results = useStore(runStore, (run) => run.results);
  const solves = useStore(runStore, (run) => run.progress !== undefined);
  const isEmpty = useStore(viewportStore, (viewport) => viewport.isEmpty);
  const previews = useStore(viewportSettings, (settings) => settings.previews);
  const model = useStore(modelStore, (store) => store.model?.name);
  const needs = modelNeeds(objects, results);
  if (needs) return <NeedsModel needs={needs} model={model} />;
  const nothing = isEmpty && !solves && results.size > 0 ? whyNothing(objects, previews) : undefined;
  return nothing ? <ShowsNothing nothing={nothing} /> : null;
}

interface ToldProps {
  children: ReactNode;
  label?: string;
  run?: () => void;
  /** Whether all is well, and nothing need be done. */
  calm?: boolean;
}

function Told({ children, label, run, calm = false }: ToldProps) {
  return (
    <div className={calm ? "viewport-telling calm" : "viewport-telling"} role="status">
      <p>{children}</p>
      {label && (
        <button type="button" onClick={run}>
          {label}
        </button>
      )}
    </div>
  );
}

function NeedsModel({ needs, model }: { needs: ModelNeeds; model: string | undefined }) {
  const told = { what: listed(needs), model: model ?? t("needs.model") };
  return (
    <Told label={t("action.model")} run={() => void action("file.model")?.run()}>
      {t(needs.isWrongModel ? "needs.wrong" : "needs.text", told)}
    </Told>
  );
}

/** The types of geometry that have a word of their own. */
const KINDS = new Set(["Point", "Curve", "Surface", "Brep", "Mesh", "SubD"]);

/** What is needed, as `1 curve and 2 surfaces`. Exported for tests. */
export function listed({ kinds }: Pick<ModelNeeds, "kinds">): string {
  const words = [...kinds].map(([kind, n]) => t(KINDS.has(kind) ? (`needs.${kind}` as Key) : "needs.other", { n }));
  const last = words.pop() ?? "";
  return words.length > 0 ? t("needs.and", { before: words.join(", "), last }) : last;
}

function ShowsNothing({ nothing }: { nothing: Nothing }) {
  switch (nothing.is) {
    case "off":
      return (
        <Told label={t("viewport.previews.all")} run={() => viewportSettings.setState({ previews: "all" })}>
          {t("nothing.off")}
        </Told>
      );
    case "hidden": {
      const { objects } = nothing;
      const show = () => void edit({ do: "change", objects, change: { is: "hidden", on: false } });
      return (
        <Told label={t("nothing.show")} run={show}>
          {t("nothing.hidden", { n: objects.length })}
        </Told>
      );
    }
    case "null":
      return (
        <Told label={t("nothing.why")} run={() => settingsStore.setState({ side: "problems" })}>
          {t("nothing.null", { n: nothing.count })}
        </Told>
      );
    case "numbers":
      return <Told calm>{t("nothing.numbers")}</Told>;
  }
}
