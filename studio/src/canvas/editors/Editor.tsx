import { useEffect, useLayoutEffect, useRef, useState, type ReactNode } from "react";

import type { Point } from "../../core/geometry";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { useCanvas, useObject } from "../hooks";
import { besideObject, closeBoxes } from "../open";
import type { EditorAt } from "../store";
import { GradientEditor } from "./GradientEditor";
import { CalendarEditor, ClockEditor } from "./MomentEditors";
import { GroupEditor, NicknameEditor, PaperEditor, StreamEditor } from "./NameEditors";
import { GraphEditor } from "./GraphEditor";
import { DigitsEditor, DomainsEditor, GenesEditor, KnobEditor } from "./NumberEditors";
import { ExpressionEditor, FormulaEditor, ValuesEditor } from "./PortEditors";
import { SwatchEditor } from "./SwatchEditor";
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
    <Sheet key={at.object + at.is + (at.port ?? "")} object={object} asked={at}>
      {inner}
    </Sheet>
  );
}

function editorOf(at: EditorAt, object: ObjectView): ReactNode | undefined {
  if (at.is === "nickname") return <NicknameEditor object={object} />;
  if (at.is === "formula") return <FormulaEditor object={object} />;
  if (at.is === "expression" && at.port) return <ExpressionEditor object={object} port={at.port} />;
  if (at.is === "values" && at.port) return <ValuesEditor object={object} port={at.port} />;
  const { control } = object;
  if (at.is === "stream" && control?.is === "panel") return <StreamEditor object={object} panel={control} />;
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
    case "calendar":
      return <CalendarEditor object={object} calendar={control} />;
    case "clock":
      return <ClockEditor object={object} clock={control} />;
    case "mdSlider":
      return <DomainsEditor object={object} control={control} />;
    case "graph":
      return <GraphEditor object={object} graph={control} />;
    case "group":
      return <GroupEditor object={object} group={control} />;
    case "swatch":
      return <SwatchEditor object={object} swatch={control} />;
    case "panel":
      return <PaperEditor object={object} panel={control} />;
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
function Sheet({ object, asked, children }: { object: ObjectView; asked: EditorAt; children: ReactNode }) {
  const box = useRef<HTMLDivElement>(null);
  const [[left, top], setPlace] = useState<Point>([-9999, 0]);
  // It opens where it leaves the object in sight: how large it is, is known once it is there.
  useLayoutEffect(() => {
    const element = box.current;
    if (element) setPlace(besideObject(object.id, [element.offsetWidth, element.offsetHeight]));
  }, [object.id]);
  // Who asks for it again, as the second click of a double-click does, has the focus in it again.
  useEffect(() => {
    box.current?.querySelector<HTMLElement>("input, textarea, select, button, [tabindex]")?.focus();
  }, [asked]);
  useEffect(() => {
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
