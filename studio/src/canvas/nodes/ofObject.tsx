import type { NodeProps } from "@xyflow/react";
import { memo, useEffect, useRef, useState, type ComponentType } from "react";

import { Boundary } from "../../app/Boundary";
import type { Point } from "../../core/geometry";
import type { ObjectView } from "../../core/protocol/ObjectView";
import type { CanvasNode } from "../flow";
import { isGliding, whenThereIsTime } from "../gliding";
import { useObject } from "../hooks";
import { Frame } from "./Frame";
import { Plainly } from "./Plainly";

/** What is drawn of an object, and where. */
export interface Shown {
  object: ObjectView;
  size: readonly [number, number];
  at: Point;
}

/** An object whose face cannot be drawn: its name in a box, which is selected and moved like any other. */
function Plain({ object, size: [width, height] }: Pick<Shown, "object" | "size">) {
  return (
    <Frame object={object} kind="capsule parameter" style={{ width, height }}>
      <span className="title">{object.nickname.trim() || object.name}</span>
    </Frame>
  );
}

/** The kinds of objects that are made of many parts. */
const HEAVY: ReadonlySet<string> = new Set(["component", "cluster", "parameter", "control"]);

/** Whether all parts of an object are drawn: one that comes into sight while the canvas is moved waits its turn. */
function useWhole(isHeavy: boolean): boolean {
  const [whole, setWhole] = useState(() => !isHeavy || !isGliding());
  useEffect(() => (whole ? undefined : whenThereIsTime(() => setWhole(true))), [whole]);
  return whole;
}

/**
 * A node that reads its object for itself: xyflow hears of places only, and looks through none of its nodes when a
 * slider is dragged.
 */
export function ofObject(Drawn: ComponentType<Shown>) {
  return memo(function OfObject({ id, data, positionAbsoluteX, positionAbsoluteY }: NodeProps<CanvasNode>) {
    const now = useObject(id);
    // An object that is gone is drawn once more before its node goes.
    const last = useRef(now);
    if (now) last.current = now;
    const object = last.current;
    const whole = useWhole(object !== undefined && HEAVY.has(object.kind));
    if (!object) return null;
    if (!whole) return <Plainly object={object} size={data.size} />;
    return (
      <Boundary of={object} fallback={<Plain object={object} size={data.size} />}>
        <Drawn object={object} size={data.size} at={[positionAbsoluteX, positionAbsoluteY]} />
      </Boundary>
    );
  });
}
