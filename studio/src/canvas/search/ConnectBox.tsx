import { useCallback, useEffect, useMemo } from "react";

import { fit } from "../../core/kinds";
import type { Grip } from "../../core/hit";
import { readingOrder } from "../../core/order";
import { documentStore } from "../../state/document";
import { t } from "../../i18n";
import { joinGrips } from "../edits";
import { joins } from "../gestures/chart";
import { gripOf, rectNow } from "../gestures/world";
import { useCanvas } from "../hooks";
import { canvasStore, say } from "../store";
import { windowPoint } from "../view";
import { PickList, type Pick } from "./PickList";

/** Connecting without a drag: the grips that a wire can be led to, to be chosen from a list. */
export function ConnectBox() {
  const from = useCanvas((canvas) => canvas.connecting);
  const all = useMemo(() => (from ? candidates(from) : []), [from]);
  const show = useCallback(
    (key: string | undefined) => {
      if (from) highlight(from, all.find((one) => one.key === key)?.grip);
    },
    [from, all],
  );
  useEffect(() => {
    if (from) return () => canvasStore.setState({ wire: undefined });
    return undefined;
  }, [from]);
  if (!from) return null;
  return (
    <PickList
      key={from.port}
      pixel={windowPoint(from.at)}
      label={t("canvas.connect.label", { name: nameOf(from) })}
      prompt={t(from.side === "output" ? "canvas.connect.input" : "canvas.connect.output")}
      none={t("canvas.connect.none")}
      always
      picks={(query) => all.filter(({ words }) => words.includes(query.trim().toLowerCase())).slice(0, 60)}
      onHighlight={show}
    />
  );
}

interface Candidate extends Pick {
  grip: Grip;
  words: string;
  fits: number;
}

function portOf(grip: Grip) {
  const object = documentStore.getState().objects.get(grip.object);
  const ports = grip.side === "input" ? object?.inputs : object?.outputs;
  return { object, port: ports?.find((one) => one.id === grip.port) };
}

function nameOf(grip: Grip): string {
  const { object, port } = portOf(grip);
  return `${object?.nickname.trim() || object?.name || ""} · ${port?.name ?? ""}`;
}

/** The grips that a wire from here can go to: fitting types first, then as the keyboard goes through the canvas. */
function candidates(from: Grip): Candidate[] {
  const { objects } = documentStore.getState();
  const kind = portOf(from).port?.kind ?? "";
  const order = readingOrder([...objects.values()].map((object) => [object.id, rectNow(object)]));
  const found: Candidate[] = [];
  for (const id of order) {
    const object = objects.get(id);
    if (!object) continue;
    for (const port of from.side === "output" ? object.inputs : object.outputs) {
      const grip = gripOf(port.id, from.side === "output" ? "input" : "output");
      if (!grip || !joins(from, grip, "replace")) continue;
      const label = nameOf(grip);
      const fits = from.side === "output" ? fit(kind, port.kind) : fit(port.kind, kind);
      const run = async () => {
        const how = from.side === "output" && port.sources.length > 0 ? "add" : "replace";
        const joined = await joinGrips(from, grip, how);
        if (joined) say(t("canvas.connect.done", { from: nameOf(from), to: label }));
      };
      found.push({ key: grip.object + grip.port, label, hint: port.kind, words: label.toLowerCase(), grip, fits, run: () => void run() });
    }
  }
  return found.sort((a, b) => b.fits - a.fits);
}

/** Shows the wire that would be drawn. */
function highlight(from: Grip, to: Grip | undefined): void {
  const wire = to && { grip: from, more: [], to: to.at, end: to, how: "replace" as const };
  canvasStore.setState({ wire });
}
