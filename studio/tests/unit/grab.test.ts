import { describe, expect, test } from "vitest";

import { GrabGesture, grabsOf } from "../../src/core/grab";
import type { Point3 } from "../../src/core/preview";
import type { HeldPoint } from "../../src/core/protocol/HeldPoint";
import type { ObjectView } from "../../src/core/protocol/ObjectView";
import { nearestVertex } from "../../src/core/vertices";

/** A session that notes what it is sent, with pictures that come when they are asked for. */
function session(isTaken = true) {
  const sent: (HeldPoint | null)[] = [];
  const due: (() => void)[] = [];
  let lost = 0;
  const gesture = new GrabGesture({
    async send(held) {
      sent.push(held);
      return isTaken;
    },
    soon: (then) => due.push(then),
    lost: () => (lost += 1),
  });
  const picture = () => due.splice(0).forEach((then) => then());
  return { gesture, sent, picture, losses: () => lost };
}

const settle = () => new Promise((resolve) => setTimeout(resolve));
const A: Point3 = [1, 2, 3];

describe("dragging a particle", () => {
  test("it goes by as much as the hand, which takes hold a little beside it", () => {
    const { gesture, sent } = session();
    gesture.begin(A, [1.5, 2, 3], 0.7);
    expect(sent).toEqual([{ from: A, to: A, reach: 0.7 }]);
    gesture.solved();
    gesture.move([2.5, 2, 5]);
    expect(gesture.held?.to).toEqual([2, 2, 5]);
  });

  test("while a solve runs moves wait, and only the newest goes", () => {
    const { gesture, sent } = session();
    gesture.begin(A, A, 1);
    for (const x of [2, 3, 4]) gesture.move([x, 2, 3]);
    expect(sent).toHaveLength(1);
    gesture.solved();
    expect(sent.map((held) => held?.to[0])).toEqual([1, 4]);
  });

  test("while the hand rests the solver goes on, once a picture", () => {
    const { gesture, sent, picture } = session();
    gesture.begin(A, A, 1);
    gesture.solved();
    expect(sent).toHaveLength(1);
    picture();
    gesture.solved();
    picture();
    expect(sent).toEqual([sent[0], sent[0], sent[0]]);
    // The end of a solve that it did not ask for moves nothing.
    gesture.solved();
    gesture.end();
    picture();
    gesture.solved();
    expect(sent).toHaveLength(4);
  });

  test("letting go is told at once and once, and ends it", () => {
    const { gesture, sent, picture } = session();
    gesture.begin(A, A, 1);
    gesture.move([9, 9, 9]);
    gesture.end();
    gesture.end();
    expect(sent.slice(1)).toEqual([null]);
    gesture.move([8, 8, 8]);
    gesture.solved();
    picture();
    expect(sent).toHaveLength(2);
    expect(gesture.held).toBeUndefined();
  });

  test("a refusal lets go without a word to who refused", async () => {
    const { gesture, sent, losses } = session(false);
    gesture.begin(A, A, 1);
    await settle();
    expect([losses(), gesture.held, sent.length]).toEqual([1, undefined, 1]);
  });

  test("a late refusal does not end the next hold", async () => {
    const answers: ((isTaken: boolean) => void)[] = [];
    const send = () => new Promise<boolean>((resolve) => answers.push(resolve));
    const gesture = new GrabGesture({ send, soon: () => {}, lost: () => expect.fail("it is another hold") });
    gesture.begin(A, A, 1);
    gesture.end();
    gesture.begin([5, 5, 5], A, 1);
    answers[0]?.(false);
    await settle();
    expect(gesture.held?.from).toEqual([5, 5, 5]);
  });
});

test("the Grabs of a document are those that are not disabled", () => {
  const object = (id: string, component: string, disabled = false) => ({ id, component, disabled }) as ObjectView;
  const grab = "EA145D1D-7727-4D52-8DB6-C9B7100AB7F9";
  const objects = [object("a", grab), object("b", grab, true), object("c", "3d13a415-6ac5-4b59-9677-3975e4696a85"), object("d", "other")];
  expect(grabsOf(objects)).toEqual(["a", "c"]);
});

describe("the point under the pointer", () => {
  /** A parallel view along z: x and y from -1 to 1 fill a pane of 200 pixels; the depth is z. */
  const VIEW = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const at = (points: Point3[], place: [number, number], reach = 12) =>
    nearestVertex(points.flat(), VIEW, [200, 200], place, reach)?.index;

  test("the nearest within reach", () => {
    const points: Point3[] = [[0, 0, 0], [0.1, 0, 0], [0.5, 0.5, 0]];
    expect(at(points, [104, 100])).toBe(0);
    expect(at(points, [107, 100])).toBe(1);
    expect(at(points, [150, 50])).toBe(2);
    expect(at(points, [150, 70])).toBeUndefined();
    expect(at([], [100, 100])).toBeUndefined();
  });

  test("of those in one place the one before; what is behind the eye or nowhere is not taken", () => {
    expect(at([[0, 0, 0.5], [0, 0, -0.5], [0, 0, 0.2]], [100, 100])).toBe(1);
    const behind = [...VIEW.slice(0, 15), -1];
    expect(nearestVertex([0, 0, 0], behind, [200, 200], [100, 100], 12)).toBeUndefined();
    expect(at([[NaN, 0, 0], [0, 0, 0]], [100, 100])).toBe(1);
  });
});
