import { useEffect, useRef } from "react";

import { css, inkOn, luminance } from "../../core/colours";
import { blobPath, groupFrame, members } from "../../core/groups";
import { rectOf } from "../../core/places";
import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { documentStore } from "../../state/document";
import { reshape } from "../edits";
import { useCanvas, useFocus, useFound, useFullNames, useSelected } from "../hooks";
import { closeBoxes } from "../open";
import { canvasStore } from "../store";
import type { Shown } from "./ofObject";

/** A frame behind objects, with its label. */
export function Group({ object, size, at }: Shown) {
  const selected = useSelected(object.id);
  const found = useFound(object.id);
  const active = useCanvas((canvas) => canvas.active === object.id);
  const full = useFullNames();
  useFocus(object.id, active);
  const { control } = object;
  if (control?.is !== "group") return null;
  const label = control.label.trim();
  const blob = control.border === "blob" ? blobOf(object, full, at) : "";
  const strong = luminance(control.colour) * (control.colour[3] / 255) < 0.12 && control.colour[3] > 140;
  return (
    <div
      className={`group as-${control.border} ${selected ? "selected" : ""} ${strong ? "strong" : ""} ${found ? "found" : ""}`}
      style={{ width: size[0], height: size[1], ...(blob === "" ? { background: css(control.colour) } : {}) }}
      role="group"
      aria-roledescription={t("canvas.group")}
      aria-label={t("canvas.group.spoken", { label: label || t("canvas.group.unnamed"), count: control.members.length })}
      tabIndex={active ? 0 : -1}
      data-object={object.id}
      data-group
    >
      {blob === "" ? null : (
        <svg className="blob" width={size[0]} height={size[1]} overflow="visible" aria-hidden="true">
          <path d={blob} fill={css(control.colour)} />
        </svg>
      )}
      {label === "" ? null : <span className="label">{label}</span>}
    </div>
  );
}

/** The blob about the members where they stand; it is drawn from the node's corner. */
function blobOf(object: ObjectView, full: boolean, origin: readonly [number, number]): string {
  const { objects } = documentStore.getState();
  const { shifts } = canvasStore.getState();
  const frames = members(object).map((id) => groupFrame(id, objects, (member) => rectOf(member, shifts, full)));
  return blobPath(
    frames.filter((frame) => frame !== undefined),
    origin,
  );
}

type ScribbleControl = Extract<Control, { is: "scribble" }>;

/** A free text, maybe turned. */
export function Scribble({ object, size, at }: Shown) {
  const selected = useSelected(object.id);
  const found = useFound(object.id);
  const active = useCanvas((canvas) => canvas.active === object.id);
  const writing = useCanvas((canvas) => canvas.writing === object.id);
  useFocus(object.id, active);
  const { control } = object;
  if (control?.is !== "scribble") return null;
  const [a, b] = control.corners;
  const angle = Math.atan2(b[1] - a[1], b[0] - a[0]);
  const turned = Number.isFinite(angle) && Math.abs(angle) > 0.01;
  const text = {
    fontFamily: `"${control.font.replaceAll('"', "")}", var(--canvas-font)`,
    fontSize: Math.min(Math.max(control.size, 4), 400),
    fontWeight: control.bold ? 700 : 400,
    fontStyle: control.italic ? "italic" : "normal",
  };
  const place = turned
    ? { left: a[0] - at[0], top: a[1] - at[1], transform: `rotate(${angle}rad)` }
    : {};
  return (
    <div
      className={`scribble ${selected ? "selected" : ""} ${turned ? "turned" : ""} ${found ? "found" : ""}`}
      style={{ width: size[0], height: size[1], ...text }}
      role="note"
      tabIndex={active ? 0 : -1}
      data-object={object.id}
    >
      {writing ? <Writing object={object} scribble={control} /> : <span style={place}>{control.text}</span>}
    </div>
  );
}

function Writing({ object, scribble }: { object: ObjectView; scribble: ScribbleControl }) {
  const field = useRef<HTMLTextAreaElement>(null);
  const done = useRef(false);
  useEffect(() => {
    field.current?.focus();
    field.current?.select();
  }, []);
  const finish = (take: boolean) => {
    if (done.current) return;
    done.current = true;
    const text = field.current?.value ?? scribble.text;
    canvasStore.setState({ writing: undefined });
    if (take && text !== scribble.text) reshape(object.id, { ...scribble, text });
  };
  return (
    <textarea
      ref={field}
      data-own
      aria-label={t("canvas.scribble.text")}
      defaultValue={scribble.text}
      onPointerDown={(event) => event.stopPropagation()}
      onBlur={() => finish(true)}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key !== "Escape" && !(event.key === "Enter" && !event.shiftKey)) return;
        finish(true);
        closeBoxes();
      }}
    />
  );
}

/** Drawn lines. Their points are on the canvas, so they are moved to the node's corner. */
export function Sketch({ object, size }: Shown) {
  const selected = useSelected(object.id);
  const found = useFound(object.id);
  const { control } = object;
  if (control?.is !== "sketch") return null;
  const [x, y] = object.bounds;
  return (
    <div
      className={`sketch ${selected ? "selected" : ""} ${found ? "found" : ""}`}
      style={{ width: size[0], height: size[1] }}
      role="img"
      aria-label={t("canvas.sketch")}
      data-object={object.id}
    >
      <svg width={size[0]} height={size[1]} overflow="visible" aria-hidden="true" className={`ink-${inkOn(control.colour)}`}>
        {control.lines.map((line, k) => (
          <polyline
            key={k}
            points={line.map((point) => `${point[0] - x},${point[1] - y}`).join(" ")}
            stroke={css(control.colour)}
            strokeWidth={Math.min(Math.max(control.width, 0.2), 100)}
          />
        ))}
      </svg>
    </div>
  );
}
