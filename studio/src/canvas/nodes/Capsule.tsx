import { memo } from "react";

import { IDS } from "../../core/catalogue";
import { capsuleLayout, portSize, tornPath } from "../../core/capsule";
import { modifiers, portName, sign } from "../../core/ports";
import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import type { PortView } from "../../core/protocol/PortView";
import { textWidth } from "../../core/text";
import { t } from "../../i18n";
import { Icon } from "../../icons/Icon";
import { addPort, removePort, reshape } from "../edits";
import { useCanvas, useFullNames, useNear } from "../hooks";
import { isViewer } from "../open";
import { Frame } from "./Frame";
import type { Shown } from "./ofObject";
import { ChartFace, isChart } from "./ChartFaces";
import { GalleryFace } from "./GalleryFace";
import { LinesFace, ViewerFace } from "./ShowFaces";

/** How large the picture of a component is at most. */
const ICON = 24;

/** A component or cluster: names of inputs on the left, the band with its name, names of outputs on the right. */
export function Capsule({ object, size }: Shown) {
  const [width, height] = size;
  const full = useFullNames();
  const layout = capsuleLayout(object, width, full);
  const torn = layout.tornLeft || layout.tornRight;
  const [from, to] = layout.band;
  const name = (full ? object.name : object.nickname.trim()) || object.name;
  const kind = `capsule ${torn ? "torn" : ""} ${object.kind === "cluster" ? "cluster" : ""}`;
  return (
    <Frame object={object} kind={kind} style={{ width, height }}>
      {torn ? (
        <svg className="outline" width={width} height={height} aria-hidden="true">
          <path d={tornPath(width, height, layout.tornLeft, layout.tornRight)} />
        </svg>
      ) : null}
      <Names side="input" object={object} ports={object.inputs} width={from - 3} full={full} />
      <div className={layout.upright ? "band upright" : "band"} style={{ left: from, width: to - from, fontSize: layout.nameSize }}>
        <Name object={object} name={name} room={[to - from, height]} />
      </div>
      <Names side="output" object={object} ports={object.outputs} width={width - to - 3} full={full} />
      {object.kind === "component" ? <MorePorts object={object} /> : null}
      <Origin object={object} />
    </Frame>
  );
}

/** What a capsule is called, or its picture where those are on. */
function Name({ object, name, room: [width, height] }: { object: ObjectView; name: string; room: readonly [number, number] }) {
  const icons = useCanvas((canvas) => canvas.icons);
  if (!icons || object.kind === "cluster") return <span>{name}</span>;
  return <Icon component={object.component} name={object.name} size={Math.min(ICON, height - 2, width)} />;
}

interface NamesProps {
  side: "input" | "output";
  object: ObjectView;
  ports: readonly PortView[];
  width: number;
  full: boolean;
}

function Names({ side, object, ports, width, full }: NamesProps) {
  const fontSize = portSize(object);
  return ports.map((port) => (
    <PortName key={port.id} port={port} side={side} style={{ top: port.at, width, fontSize }} full={full} />
  ));
}

interface PortNameProps {
  port: PortView;
  side: "input" | "output";
  style: { top: number; width: number; fontSize: number };
  full: boolean;
}

/** From the edge of a capsule to the names of its ports. */
const PORT_EDGE = 6;

const PortName = memo(
  function PortName({ port, side, style, full }: PortNameProps) {
    const marks = modifiers(port);
    const name = portName(port, full);
    const isCut = marks.length > 0 || textWidth(name, style.fontSize) > style.width - PORT_EDGE;
    return (
      <span className={isCut ? `port ${side} is-cut` : `port ${side}`} style={style} data-name-of={port.id} data-side={side}>
        {side === "output" ? <Marks marks={marks} /> : null}
        {name}
        {side === "input" ? <Marks marks={marks} /> : null}
      </span>
    );
  },
  (a, b) => a.port === b.port && a.full === b.full && a.style.width === b.style.width && a.style.top === b.style.top,
);

export function Marks({ marks }: { marks: ReturnType<typeof modifiers> }) {
  if (marks.length === 0) return null;
  return (
    <span className="marks" aria-label={marks.map((mark) => t(`canvas.modifier.${mark}`)).join(", ")}>
      {marks.map(sign).join("")}
    </span>
  );
}

/** The (+) and (−) of components that have any number of ports, when the canvas is near enough. */
function MorePorts({ object }: { object: ObjectView }) {
  const near = useNear();
  if (!near || (!object.variableInputs && !object.variableOutputs)) return null;
  return (
    <>
      {object.variableInputs ? <Side object={object} input /> : null}
      {object.variableOutputs ? <Side object={object} input={false} /> : null}
    </>
  );
}

function Side({ object, input }: { object: ObjectView; input: boolean }) {
  const ports = input ? object.inputs : object.outputs;
  const height = object.bounds[3];
  const between = (index: number) => {
    const [above, below] = [ports[index - 1]?.at, ports[index]?.at];
    if (above === undefined) return 2;
    return below === undefined ? height - 2 : (above + below) / 2;
  };
  const where = input ? "input" : "output";
  return (
    <>
      {Array.from({ length: ports.length + 1 }, (_, index) => (
        <button
          key={`add${index}`}
          type="button"
          tabIndex={-1}
          className={`more ${where} nodrag`}
          style={{ top: between(index) }}
          aria-label={t("canvas.port.add")}
          data-own
          onClick={() => addPort(object.id, input, index)}
        >
          +
        </button>
      ))}
      {ports
        .filter((port) => port.removable)
        .map((port) => (
          <button
            key={`remove${port.id}`}
            type="button"
            tabIndex={-1}
            className={`more less ${where} nodrag`}
            style={{ top: port.at }}
            aria-label={t("canvas.port.remove", { name: port.nickname })}
            data-own
            onClick={() => removePort(port.id)}
          >
            −
          </button>
        ))}
    </>
  );
}

/** The add-on that an object comes from which cannot run here. */
function Origin({ object }: { object: ObjectView }) {
  if (object.support.is !== "no") return null;
  return <div className="origin">{object.support.plugin ?? t("canvas.unsupported")}</div>;
}

/** A parameter that is no higher than this shows its name, and nothing else that it might have to show. */
const SHOWS_ABOVE = 32;

/** What a large parameter shows of itself. */
function inside(object: ObjectView, size: readonly [number, number], drawing: boolean) {
  const { control } = object;
  if (isViewer(object)) return { kind: "face-viewer", face: <ViewerFace object={object} text={!drawing} size={size} /> };
  if (object.component === IDS.imageGallery) return { kind: "face-gallery", face: <GalleryFace object={object} size={size} /> };
  if (isChart(object)) return { kind: "face-chart", face: <ChartFace object={object} size={size} /> };
  if (control?.is === "cherry") return lines(object, [`${control.path} (${control.index})`]);
  if (control?.is === "paths") return lines(object, control.rules.map(([from, to]) => `${from} → ${to}`));
  return undefined;
}

function lines(object: ObjectView, told: readonly string[]) {
  return { kind: "face-lines", face: <LinesFace object={object} lines={told} /> };
}

/** A floating parameter: a small capsule that is its own port. */
export function Parameter({ object, size }: Shown) {
  const full = useFullNames();
  const own = object.inputs[0] ?? object.outputs[0];
  const name = (full ? object.name : object.nickname.trim()) || object.name;
  const drawing = useCanvas((canvas) => canvas.drawing.has(object.id));
  const shown = size[1] > SHOWS_ABOVE ? inside(object, size, drawing) : undefined;
  if (shown) {
    return (
      <Frame object={object} kind={`capsule control ${shown.kind}`} style={{ width: size[0], height: size[1] }}>
        {shown.face}
      </Frame>
    );
  }
  return (
    <Frame object={object} kind="capsule parameter" style={{ width: size[0], height: size[1] }}>
      {object.control?.is === "recorder" ? <RecordMark object={object} recorder={object.control} /> : null}
      <span className="title">
        <Name object={object} name={name} room={size} />
        {own ? <Marks marks={modifiers(own)} /> : null}
      </span>
      <Origin object={object} />
    </Frame>
  );
}

/** Whether a Data Recorder records: a press turns it. */
function RecordMark({ object, recorder }: { object: ObjectView; recorder: Extract<Control, { is: "recorder" }> }) {
  return (
    <button
      type="button"
      className={recorder.recording ? "record on" : "record"}
      tabIndex={-1}
      data-own
      data-inner
      aria-pressed={recorder.recording}
      aria-label={t("canvas.menu.recording")}
      title={t("canvas.menu.recording")}
      onClick={() => reshape(object.id, { ...recorder, recording: !recorder.recording })}
      onDoubleClick={(event) => event.stopPropagation()}
    />
  );
}

/** A dot on a wire. */
export function Relay({ object, size }: Shown) {
  return (
    <Frame object={object} kind="relay" style={{ width: size[0], height: size[1] }}>
      <span className="dot" />
    </Frame>
  );
}
