import type { ReactNode } from "react";

import type { ObjectView } from "../../core/protocol/ObjectView";
import { ButtonFace, SwatchFace, ToggleFace } from "./SmallFaces";
import { DigitsFace, GenesFace, KnobFace, MdSliderFace } from "./NumberFaces";
import { Frame } from "./Frame";
import type { Shown } from "./ofObject";
import { GradientFace } from "./GradientFace";
import { GraphFace } from "./GraphFace";
import { CalendarFace, ClockFace } from "./MomentFaces";
import { PanelNode } from "./PanelNode";
import { SliderFace } from "./SliderFace";
import { ValueListFace } from "./ValueListFace";
import { ImageFace } from "./ShowFaces";
import { Capsule, Parameter } from "./Capsule";

/** An object that its user sets, or that shows something: its control says which. */
export function Control(props: Shown) {
  const { object, size } = props;
  const { control } = object;
  if (control?.is === "panel") return <PanelNode object={object} panel={control} size={size} />;
  const inner = face(object, size);
  if (inner === undefined) {
    const plain = object.inputs.length + object.outputs.length > 2 || object.inputs[0]?.id !== object.outputs[0]?.id;
    return plain ? <Capsule {...props} /> : <Parameter {...props} />;
  }
  return (
    <Frame object={object} kind={`capsule control face-${control?.is ?? ""}`} style={{ width: size[0], height: size[1] }}>
      {inner}
    </Frame>
  );
}

function face(object: ObjectView, [width, height]: readonly [number, number]): ReactNode | undefined {
  const { control } = object;
  switch (control?.is) {
    case "slider":
      return <SliderFace object={object} slider={control} width={width} />;
    case "toggle":
      return <ToggleFace object={object} on={control.on} width={width} />;
    case "button":
      return <ButtonFace object={object} width={width} />;
    case "valueList":
      return <ValueListFace object={object} list={control} size={[width, height]} />;
    case "swatch":
      return <SwatchFace object={object} colour={control.colour} width={width} />;
    case "mdSlider":
      return <MdSliderFace object={object} control={control} size={[width, height]} />;
    case "knob":
      return <KnobFace object={object} knob={control} size={[width, height]} />;
    case "digits":
      return <DigitsFace object={object} digits={control} width={width} />;
    case "calendar":
      return <CalendarFace object={object} calendar={control} size={[width, height]} />;
    case "clock":
      return <ClockFace object={object} clock={control} size={[width, height]} />;
    case "genes":
      return <GenesFace object={object} genes={control} size={[width, height]} />;
    case "graph":
      return <GraphFace object={object} graph={control} size={[width, height]} />;
    case "gradient":
      return <GradientFace object={object} gradient={control} width={width} />;
    case "image":
      return <ImageFace object={object} file={control.file} hash={control.hash} />;
    default:
      return undefined;
  }
}
