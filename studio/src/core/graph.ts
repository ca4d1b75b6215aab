/** Graph Mappers: their functions, and where the handles of each may go. */

import { clamp, type Point } from "./geometry";
import type { GraphView } from "./protocol/GraphView";

/**
 * The functions that can be chosen: those of which it is known how files name them. Others that a file has are drawn
 * and their handles dragged all the same. Where the handles of a new one begin is the session's affair.
 */
export const GRAPHS = ["Bezier", "Gaussian", "Linear", "Parabola", "Sine"] as const;

/** What a menu of functions offers: those that can be chosen, and the one that is there. */
export function graphChoices(now: string): string[] {
  const known: readonly string[] = GRAPHS;
  return now === "" || known.includes(now) ? [...known] : [...known, now].sort();
}

/** The handles that are places to be dragged; others hold numbers of the function, such as an exponent. */
export function draggable({ name, handles }: GraphView): number[] {
  const count = name === "Perlin" ? 0 : name === "Power" ? 1 : handles.length;
  return handles.slice(0, count).map((_, index) => index);
}

/** A handle's place when it is dragged to a point: ends of curves stay at their edge of the square. */
export function handleAt(graph: GraphView, index: number, to: Point): [number, number] {
  const [x, y] = [clamp(to[0], 0, 1), clamp(to[1], 0, 1)];
  if (graph.name === "Linear") return [index === 0 ? 0 : 1, y];
  if (graph.name === "Bezier" && index === 0) return [0, y];
  if (graph.name === "Bezier" && index === 3) return [1, y];
  // A power goes through a point inside the square: through its edges there is none, or more than one.
  if (graph.name === "Power") return [clamp(x, 0.01, 0.99), clamp(y, 0.01, 0.99)];
  return [x, y];
}

/** The graph with one of its handles elsewhere. */
export function withHandle(graph: GraphView, index: number, to: Point): GraphView {
  const place = handleAt(graph, index, to);
  const [old, side] = graph.handles;
  // The middle of a Gaussian takes its width along.
  if (graph.name === "Gaussian" && index === 0 && old && side) {
    return { ...graph, handles: [place, [place[0] + side[0] - old[0], place[1] / 2]] };
  }
  const handles = graph.handles.map((handle, k) => (k === index ? place : handle));
  return { ...graph, handles };
}

/** The lines from handles to what they pull at, for functions that have such. */
export function arms({ name, handles }: GraphView): [Point, Point][] {
  const [a, b, c, d] = handles;
  return name === "Bezier" && a && b && c && d ? [[a, b], [d, c]] : [];
}
