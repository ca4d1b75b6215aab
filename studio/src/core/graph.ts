/** Graph Mappers: their functions, and where the handles of each may go. */

import { clamp, type Point } from "./geometry";
import type { GraphView } from "./protocol/GraphView";

/** The functions that can be chosen, each with where its handles begin, in the unit square with y upwards. */
export const GRAPHS: readonly GraphView[] = [
  { name: "Bezier", handles: [[0, 0], [0.35, 0], [0.65, 1], [1, 1]] },
  { name: "Gaussian", handles: [[0.5, 1], [0.7, 0.6]] },
  { name: "Linear", handles: [[0, 0], [1, 1]] },
  { name: "Parabola", handles: [[0.5, 0], [1, 1]] },
  { name: "Perlin", handles: [[0, 0.5], [0.2, 0.8]] },
  { name: "Power", handles: [[0.5, 0.25]] },
  { name: "Sine", handles: [[0.25, 1], [0.75, 0]] },
  { name: "Sine Summation", handles: [[0.25, 0.75], [0.75, 0.25], [0.1, 0.6], [0.2, 0.4]] },
];

/** A handle's place when it is dragged to a point: ends of curves stay at their edge of the square. */
export function handleAt(graph: GraphView, index: number, to: Point): [number, number] {
  const [x, y] = [clamp(to[0], 0, 1), clamp(to[1], 0, 1)];
  if (graph.name === "Linear") return [index === 0 ? 0 : 1, y];
  if (graph.name === "Bezier" && index === 0) return [0, y];
  if (graph.name === "Bezier" && index === 3) return [1, y];
  return [x, y];
}

/** The graph with one of its handles elsewhere. */
export function withHandle(graph: GraphView, index: number, to: Point): GraphView {
  const handles = graph.handles.map((old, k) => (k === index ? handleAt(graph, index, to) : old));
  return { ...graph, handles };
}

/** The lines from handles to what they pull at, for functions that have such. */
export function arms({ name, handles }: GraphView): [Point, Point][] {
  const [a, b, c, d] = handles;
  return name === "Bezier" && a && b && c && d ? [[a, b], [d, c]] : [];
}
