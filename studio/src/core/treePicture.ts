/** A data tree as a picture: its paths as branches that fork from the middle outwards. */

import { polar } from "./radial";
import type { Point } from "./geometry";

export interface TreePicture {
  twigs: { from: Point; to: Point }[];
  /** The ends that hold data. */
  leaves: Point[];
}

interface Twig {
  children: Map<number, Twig>;
  leaf: boolean;
}

/** The numbers of a path as it is written: `{0;1}`. */
export function pathNumbers(path: string): number[] {
  return (path.match(/-?\d+/g) ?? []).map(Number);
}

/** The twigs of paths about the origin, within a radius. Ends stand evenly around; forks in the middle of their own. */
export function treePicture(paths: readonly (readonly number[])[], radius: number): TreePicture {
  const root: Twig = { children: new Map(), leaf: false };
  let depth = 0;
  for (const path of paths) {
    let at = root;
    for (const index of path) {
      const next = at.children.get(index) ?? { children: new Map<number, Twig>(), leaf: false };
      at.children.set(index, next);
      at = next;
    }
    at.leaf = true;
    depth = Math.max(depth, path.length);
  }
  // What all paths begin with is no fork, and would only be a line.
  let stem = root;
  let level = 0;
  while (stem.children.size === 1 && !stem.leaf) {
    stem = [...stem.children.values()][0] ?? stem;
    level += 1;
  }
  const ring = radius / Math.max(depth - level, 1);
  const count = Math.max(ends(stem), 1);
  const picture: TreePicture = { twigs: [], leaves: [] };
  let placed = 0;
  const grow = (twig: Twig, up: number, from: Point | undefined): void => {
    const angle = (2 * Math.PI * (placed + (ends(twig) - 1) / 2)) / count;
    const at: Point = up === 0 ? [0, 0] : polar(angle, up * ring);
    if (from) picture.twigs.push({ from, to: at });
    if (twig.leaf) picture.leaves.push(at);
    if (twig.children.size === 0) placed += 1;
    for (const [, child] of [...twig.children].sort(([a], [b]) => a - b)) grow(child, up + 1, at);
  };
  grow(stem, 0, undefined);
  return picture;
}

/** How many ends a twig has. */
function ends(twig: Twig): number {
  if (twig.children.size === 0) return 1;
  let sum = 0;
  for (const child of twig.children.values()) sum += ends(child);
  return sum;
}
