import { useEffect } from "react";

import { found, headOf } from "../../core/find";
import { t } from "../../i18n";
import { documentStore } from "../../state/document";
import { goTo } from "../gestures/more";
import { useCanvas } from "../hooks";
import { canvasStore } from "../store";
import { paneSize, reveal } from "../view";
import { PickList, type Pick } from "./PickList";

const MOST = 60;

/**
 * Finds objects by their names and what is written on them, and goes to the one that is chosen. Meanwhile all others
 * are faint, and arrows at the edge point to those that are out of sight.
 */
export function FindBox() {
  const open = useCanvas((canvas) => canvas.finding);
  useEffect(() => {
    if (open) return () => canvasStore.setState({ found: undefined });
    return undefined;
  }, [open]);
  if (!open) return null;
  return (
    <PickList
      pixel={[paneSize()[0] - 350, 24]}
      label={t("canvas.find.label")}
      prompt={t("canvas.find.prompt")}
      none={t("canvas.find.none")}
      picks={picks}
      onQuery={mark}
      onHighlight={show}
    />
  );
}

/** Marks what is found; while nothing is asked for, nothing is marked. */
function mark(query: string): void {
  const hits = found(documentStore.getState().objects.values(), query).map((object) => object.id);
  canvasStore.setState({ found: query.trim() === "" ? undefined : new Set(hits) });
}

function show(id: string | undefined): void {
  if (id !== undefined) reveal(id);
}

function picks(query: string): Pick[] {
  const { objects } = documentStore.getState();
  return found(objects.values(), query)
    .slice(0, MOST)
    .map((object) => ({
      key: object.id,
      label: headOf(object).slice(0, 60),
      hint: object.name,
      run: () => goTo(object.id, false),
    }));
}
