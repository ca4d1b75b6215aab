/**
 * Points that handles move: those that a Point parameter keeps, which go where they are dragged, and those that an object
 * computes, for which sliders are found that bring them there.
 */

import { parsePoint, rowsText, withPoint } from "../../core/pointText";
import type { Point3 } from "../../core/preview";
import type { ObjectView } from "../../core/protocol/ObjectView";
import type { Row } from "../../core/protocol/Row";
import { t } from "../../i18n";
import { documentStore } from "../../state/document";
import { movableInputs, studyStore, targetOf } from "../../state/study";
import { ask, edit } from "../../state/session";

/** More handles than this hide the model. */
const MOST = 200;
/** Grasshopper's Point parameter. */
const POINT_PARAMETER = "fbac3e32-f100-4292-8692-77240a42fd1a";

/** The points of an object, and what moves them. */
export interface HeldPoints {
  object: ObjectView;
  points: { point: Point3 }[];
  /** Moves one in the document; `done` with the last move of a drag. Gives what came of it, where that needs words. */
  move(at: number, point: Point3, gesture: number, done: boolean): Promise<string | undefined>;
}

/** Whether an object is a Point parameter that keeps its points itself. */
export function keepsPoints({ component, kind, inputs }: ObjectView): boolean {
  const port = inputs[0];
  return kind === "parameter" && component.toLowerCase() === POINT_PARAMETER && port !== undefined
    && port.sources.length === 0 && port.kept > 0;
}

/** The output of computed points that may be dragged; none unless somebody wants that. */
function computedPoints(object: ObjectView): string | undefined {
  const { drags, target } = studyStore.getState();
  if (!drags || documentStore.getState().within.length > 0) return undefined;
  const port = object.outputs.find(({ id }) => id === target) ?? object.outputs.find(({ kind }) => kind === "Point");
  return port?.kind === "Point" ? port.id : undefined;
}

/** What handles move of an object; nothing where there is nothing, or more than hands can hold. */
export async function heldPoints(object: ObjectView): Promise<HeldPoints | undefined> {
  if (keepsPoints(object)) {
    const rows = await rowsOf(object.inputs[0]?.id ?? object.id);
    return rows && kept(object, rows);
  }
  const output = computedPoints(object);
  const rows = output && (await rowsOf(output));
  return output && rows ? wanted(object, output, rows) : undefined;
}

async function rowsOf(port: string): Promise<readonly Row[] | undefined> {
  const { within } = documentStore.getState();
  const answer = await ask({ ask: "rows", port, from: 0, count: MOST * 2, exact: true, within });
  return answer.event === "rows" && answer.page.rows.length === answer.page.total ? answer.page.rows : undefined;
}

function kept(object: ObjectView, found: readonly Row[]): HeldPoints {
  let rows = found;
  const points = pointsOf(rows);
  const port = object.inputs[0]?.id ?? object.id;
  return {
    object,
    points,
    async move(at, point, gesture) {
      const row = points[at]?.row;
      if (row === undefined) return undefined;
      rows = withPoint(rows, row, point);
      await edit({ do: "keep", port, values: rowsText(rows) }, gesture);
      return undefined;
    },
  };
}

function wanted(object: ObjectView, output: string, rows: readonly Row[]): HeldPoints {
  const places = placesOf(rows);
  const points = pointsOf(rows);
  return {
    object,
    points,
    async move(at, point, gesture, done) {
      const item = places[points[at]?.row ?? -1];
      if (!item) return undefined;
      const wants = [{ target: targetOf(output, item), numbers: [...point] }];
      const answer = await ask({ ask: "solveFor", wants, with: movableInputs(), quick: !done, gesture });
      if (answer.event !== "solved") return undefined;
      studyStore.setState({ solved: answer.solved });
      return t("effects.off", { off: Number(answer.solved.off.toPrecision(3)) });
    },
  };
}

/** The points among rows, with the number of their row. Exported for tests. */
export function pointsOf(rows: readonly Row[]): { row: number; point: Point3 }[] {
  return rows.flatMap((row, index) => {
    const point = row.is === "item" ? parsePoint(row.text) : undefined;
    return point ? [{ row: index, point }] : [];
  });
}

/** The branch and place of the item of each row; none for those of paths. Exported for tests. */
export function placesOf(rows: readonly Row[]): ({ path: string; index: number } | undefined)[] {
  let path = "{0}";
  return rows.map((row) => {
    if (row.is === "item") return { path, index: row.index };
    path = row.path;
    return undefined;
  });
}
