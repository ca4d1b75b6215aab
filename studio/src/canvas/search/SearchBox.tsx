import { useStore } from "zustand";

import { placing } from "../../core/initial";
import { parsePopup } from "../../core/popup";
import { likelyAfter } from "../../core/likely";
import { portFor, search, type Found, type Wanted } from "../../core/search";
import type { Grip } from "../../core/hit";
import { t } from "../../i18n";
import { Icon } from "../../icons/Icon";
import { catalogueStore, type Catalogue } from "../../state/catalogue";
import { documentStore } from "../../state/document";
import { likelyStore } from "../../state/likely";
import { place, placeWired } from "../edits";
import { useCanvas } from "../hooks";
import type { SearchAt } from "../store";
import { PickList, type Pick as Listed } from "./PickList";

/** The search box: a double-click on the empty canvas, or a wire let go in the void. */
export function SearchBox() {
  const at = useCanvas((canvas) => canvas.search);
  const catalogue = useStore(catalogueStore);
  if (!at) return null;
  const wanted = at.from ? wantedBy(at.from) : undefined;
  return (
    <PickList
      key={at.pixel.join()}
      pixel={at.pixel}
      label={t("canvas.search.label")}
      prompt={wanted ? t("canvas.search.wired", { kind: wanted.kind }) : t("canvas.search.prompt")}
      none={t(catalogue.state === "failed" ? "canvas.search.failed" : "canvas.search.none")}
      picks={(query) => picks(catalogue, at, wanted, query)}
    />
  );
}

/** What a wire that was let go could be led to: it fits the data of its port. */
function wantedBy(grip: Grip): Wanted {
  const { objects } = documentStore.getState();
  const object = objects.get(grip.object);
  const ports = grip.side === "output" ? object?.outputs : object?.inputs;
  const kind = ports?.find((port) => port.id === grip.port)?.kind ?? "";
  return { side: grip.side === "output" ? "input" : "output", kind };
}

/** What mostly reads a component comes first where nothing is typed yet. */
function likely({ byId }: Catalogue, { object }: Grip, wanted: Wanted | undefined): Pick<Found, "entry">[] {
  const component = documentStore.getState().objects.get(object)?.component;
  if (!component || wanted?.side !== "input") return [];
  return likelyAfter(likelyStore.getState().counts, component).flatMap((id) => {
    const entry = byId.get(id);
    return entry && !entry.old && portFor(entry, wanted) ? [{ entry }] : [];
  });
}

function picks(catalogue: Catalogue, at: SearchAt, wanted: Wanted | undefined, query: string): Listed[] {
  const popup = wanted ? undefined : parsePopup(query);
  const code = popup && placing(popup, catalogue.entries);
  const usual = at.from && query.trim() === "" ? likely(catalogue, at.from, wanted) : [];
  const others = search(catalogue.entries, query, wanted).filter(({ entry }) => !usual.some((one) => one.entry === entry));
  const found = [...usual, ...others].map(
    ({ entry }): Listed => ({
      key: entry.guid,
      label: entry.name,
      icon: <Icon component={entry.guid} name={entry.name} size={20} />,
      hint: [entry.tab, entry.panel].filter(Boolean).join(" › "),
      run() {
        if (at.from) void placeWired(entry.guid, at.at, at.from, at.more);
        else void place({ component: entry.guid, with: null }, at.at);
      },
    }),
  );
  if (!code) return query.trim() === "" && !wanted ? [] : found;
  const first: Listed = {
    key: "code",
    label: code.name,
    icon: <Icon component={code.component} name={code.name} size={20} />,
    hint: query.trim(),
    run: () => void place(code, at.at),
  };
  return [first, ...found];
}
