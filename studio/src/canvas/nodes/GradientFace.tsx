import { useEffect, useState, type PointerEvent } from "react";

import { css, gradientCss } from "../../core/colours";
import { clamp } from "../../core/geometry";
import { withGrip, withoutGrip } from "../../core/gradient";
import type { Control } from "../../core/protocol/Control";
import type { GripView } from "../../core/protocol/GripView";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { follow } from "../drag";
import { liveShape, reshape } from "../edits";
import { openEditor } from "../open";
import { lens } from "../view";

type Gradient = Extract<Control, { is: "gradient" }>;
const LEFT = 22;
const RIGHT = 10;
/** So many pixels off its strip a grip is dragged away. */
const AWAY = 40;

/** A Gradient: its colours, and the grips that they are fixed at. */
export function GradientFace({ object, gradient, width }: { object: ObjectView; gradient: Gradient; width: number }) {
  const [live, setLive] = useState<GripView[] | undefined>(undefined);
  useEffect(() => setLive(undefined), [gradient]);
  const grips = live ?? gradient.grips;
  const room = Math.max(width - LEFT - RIGHT, 10);
  const press = (index: number) => (event: PointerEvent<HTMLSpanElement>) => {
    const start = grips[index]?.at ?? 0;
    const shape = liveShape(object.id);
    follow(event, {
      move([dx, dy]) {
        const at = clamp(start + dx / (room * lens().zoom), 0, 1);
        // A grip that is dragged away from its strip is gone, for as long as it is kept there.
        const away = Math.abs(dy) > AWAY && grips.length > 1;
        const next = away ? withoutGrip(grips, index) : grips.map((grip, k) => (k === index ? { ...grip, at } : grip));
        setLive(next);
        shape.send({ ...gradient, grips: next });
      },
      end: shape.end,
      abandon() {
        setLive(undefined);
        shape.abandon();
      },
    });
  };
  return (
    <div
      className="gradient"
      style={{ left: LEFT, width: room, background: gradientCss(grips) }}
      title={t("canvas.gradient.face")}
      onDoubleClick={(event) => {
        event.stopPropagation();
        const box = event.currentTarget.getBoundingClientRect();
        reshape(object.id, { ...gradient, grips: withGrip(grips, (event.clientX - box.left) / box.width) });
      }}
    >
      {grips.map((grip, index) => (
        <span
          key={index}
          className="stop"
          data-own
          style={{ left: grip.at * room, background: css(grip.right) }}
          title={t("canvas.gradient.grip", { at: Math.round(grip.at * 1000) / 1000 })}
          onPointerDown={press(index)}
          onDoubleClick={(event) => {
            event.stopPropagation();
            openEditor(object.id, "control", { index });
          }}
        />
      ))}
    </div>
  );
}
