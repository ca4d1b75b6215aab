import { useEffect, useRef, type ReactNode } from "react";

import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { useCanvas, useObject } from "../hooks";
import { below, closeBoxes } from "../open";
import type { EditorAt } from "../store";
import { GradientEditor } from "./GradientEditor";
import { GroupEditor, NicknameEditor } from "./NameEditors";
import { DigitsEditor, DomainsEditor, GenesEditor, GraphEditor, KnobEditor } from "./NumberEditors";
import { ExpressionEditor, ScriptView, ValuesEditor } from "./PortEditors";
import { SliderEditor } from "./SliderEditor";
import { ListEditor } from "./ListEditor";
import { ButtonEditor, CherryEditor, PathsEditor } from "./TextEditors";

/** The box about an object that a double-click or a menu opens. */
export function Editor() {
  const at = useCanvas((canvas) => canvas.editor);
  const object = useObject(at?.object);
  if (!at || !object) return null;
  const inner = editorOf(at, object);
  if (inner === undefined) return null;
  return (
    <Sheet key={at.object + at.is + (at.port ?? "")} object={object}>
      {inner}
    </Sheet>
  );
}

function editorOf(at: EditorAt, object: ObjectView): ReactNode | undefined {
  if (at.is === "nickname") return <NicknameEditor object={object} />;
  if (at.is === "script") return <ScriptView object={object} />;
  if (at.is === "expression" && at.port) return <ExpressionEditor object={object} port={at.port} />;
  if (at.is === "values" && at.port) return <ValuesEditor object={object} port={at.port} />;
  const { control } = object;
  switch (control?.is) {
    case "slider":
      return <SliderEditor object={object} slider={control} />;
    case "valueList":
      return <ListEditor object={object} list={control} />;
    case "gradient":
      return <GradientEditor object={object} gradient={control} index={at.index ?? 0} />;
    case "genes":
      return <GenesEditor object={object} genes={control} />;
    case "knob":
      return <KnobEditor object={object} knob={control} />;
    case "digits":
      return <DigitsEditor object={object} digits={control} />;
    case "mdSlider":
      return <DomainsEditor object={object} control={control} />;
    case "graph":
      return <GraphEditor object={object} graph={control} />;
    case "group":
      return <GroupEditor object={object} />;
    case "button":
      return <ButtonEditor object={object} button={control} />;
    case "paths":
      return <PathsEditor object={object} paths={control} />;
    case "cherry":
      return <CherryEditor object={object} cherry={control} />;
    default:
      return <NicknameEditor object={object} />;
  }
}

/** The box itself: Escape and a press elsewhere close it. */
function Sheet({ object, children }: { object: ObjectView; children: ReactNode }) {
  const box = useRef<HTMLDivElement>(null);
  const [left, top] = below(object.id);
  useEffect(() => {
    box.current?.querySelector<HTMLElement>("input, textarea, select, button, [tabindex]")?.focus();
    const close = (event: PointerEvent) => {
      if (event.target instanceof Node && !box.current?.contains(event.target)) closeBoxes();
    };
    // The press that opened it is still on its way up.
    const timer = setTimeout(() => window.addEventListener("pointerdown", close));
    return () => {
      clearTimeout(timer);
      window.removeEventListener("pointerdown", close);
    };
  }, []);
  return (
    <div
      ref={box}
      className="box sheet"
      role="dialog"
      aria-label={t("canvas.editor", { name: object.nickname.trim() || object.name })}
      style={{ left, top }}
      onPointerDown={(event) => event.stopPropagation()}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Escape") closeBoxes();
      }}
    >
      {children}
    </div>
  );
}
