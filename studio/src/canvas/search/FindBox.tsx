import { found, wordsOf } from "../../core/find";
import { t } from "../../i18n";
import { documentStore } from "../../state/document";
import { goTo } from "../gestures/more";
import { useCanvas } from "../hooks";
import { paneSize, reveal } from "../view";
import { PickList, type Pick } from "./PickList";

const MOST = 60;

/** Finds objects by their names and what is written on them, and goes to the one that is chosen. */
export function FindBox() {
  const open = useCanvas((canvas) => canvas.finding);
  if (!open) return null;
  return (
    <PickList
      pixel={[paneSize()[0] - 350, 24]}
      label={t("canvas.find.label")}
      prompt={t("canvas.find.prompt")}
      none={t("canvas.find.none")}
      picks={picks}
      onHighlight={show}
    />
  );
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
      label: (wordsOf(object).at(object.control ? -1 : 0) ?? object.name).split("\n")[0]?.slice(0, 60) ?? object.name,
      hint: object.name,
      run: () => goTo(object.id, false),
    }));
}
