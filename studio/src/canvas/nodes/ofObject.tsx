import type { NodeProps } from "@xyflow/react";
import { memo, useRef, type ComponentType } from "react";

import type { Point } from "../../core/geometry";
import type { ObjectView } from "../../core/protocol/ObjectView";
import type { CanvasNode } from "../flow";
import { useObject } from "../hooks";

/** What is drawn of an object, and where. */
export interface Shown {
  object: ObjectView;
  size: readonly [number, number];
  at: Point;
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
    return last.current ? <Drawn object={last.current} size={data.size} at={[positionAbsoluteX, positionAbsoluteY]} /> : null;
  });
}
