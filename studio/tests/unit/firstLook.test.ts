import { afterEach, beforeEach, expect, test } from "vitest";

import { forgetLook, keepLook, lens, panBy, setFlow, setPane, zoomExtents } from "../../src/canvas/view";
import type { Lens } from "../../src/core/geometry";
import { textWidth } from "../../src/core/text";
import { documentStore } from "../../src/state/document";
import { object } from "./make";

let pane = { clientWidth: 800, clientHeight: 600, dataset: {}, querySelector: () => null };
let now: Lens;
let smooth: number[];
const resize = (clientWidth: number, clientHeight: number) => {
  pane = { ...pane, clientWidth, clientHeight };
  setPane(pane as unknown as HTMLElement);
};

beforeEach(() => {
  now = { x: 0, y: 0, zoom: 1 };
  smooth = [];
  setFlow({
    getViewport: () => now,
    setViewport(to, options) {
      now = to;
      smooth.push(options?.duration ?? 0);
    },
  });
  resize(800, 600);
  // So long that all of it cannot be read: it is looked at from its beginning.
  const objects = [0, 20_000].map((y) => object(`at${y}`, { bounds: [0, y, 100, 40] }));
  documentStore.setState({ objects: new Map(objects.map((each) => [each.id, each])), order: objects.map(({ id }) => id) });
  forgetLook();
});
afterEach(() => {
  setFlow(undefined);
  setPane(undefined);
  documentStore.setState({ objects: new Map(), order: [] });
});

/** How far the window reaches down on the canvas. */
const foot = () => (pane.clientHeight - now.y) / now.zoom;

test("a long document is seen from its beginning, also in a window that became another", () => {
  keepLook();
  expect(foot()).toBeLessThan(10_000);
  expect(lens().zoom).toBeCloseTo(0.5);
  resize(400, 300);
  keepLook();
  expect(foot()).toBeLessThan(10_000);
});

test("what was asked for before the first look stays, and comes at once", () => {
  zoomExtents();
  expect(foot()).toBeGreaterThan(20_000);
  const wanted = lens();
  keepLook();
  expect(foot()).toBeGreaterThan(20_000);
  expect(lens()).toEqual(wanted);
  expect(smooth.every((duration) => duration === 0)).toBe(true);
  // All of it stays in a window that becomes lower.
  resize(800, 200);
  keepLook();
  expect(foot()).toBeGreaterThan(20_000);
});

test("a place that somebody went to stays, until another document comes", () => {
  panBy([-30, -40]);
  const there = lens();
  keepLook();
  resize(500, 500);
  keepLook();
  expect(lens()).toEqual(there);
  forgetLook();
  keepLook();
  expect(lens()).not.toEqual(there);
});

test("the label of a group is in sight, also where it is longer than its members reach", () => {
  const member = object("m", { bounds: [0, 0, 60, 20] });
  const control = { is: "group", label: "A label that is much longer than the group", members: ["m"], border: "box", colour: [0, 0, 0, 50] } as unknown as ReturnType<typeof object>["control"];
  const group = object("g", { kind: "group", control, bounds: [-10, -20, 80, 50] });
  documentStore.setState({ objects: new Map([member, group].map((each) => [each.id, each])), order: ["g", "m"] });
  forgetLook();
  resize(300, 200);
  keepLook();
  const end = -10 + 8 + textWidth("A label that is much longer than the group", 12);
  expect(end * now.zoom + now.x).toBeLessThanOrEqual(300);
});
