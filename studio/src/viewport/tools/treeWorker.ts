/** Trees of boxes over great surfaces, built beside the page so that it goes on. */

import type { BufferGeometry } from "three";
import type { MeshBVH } from "three-mesh-bvh";
import { GenerateMeshBVHWorker } from "three-mesh-bvh/worker";

let worker: GenerateMeshBVHWorker | undefined;
let last: Promise<unknown> = Promise.resolve();

/** Builds one after the other: the worker takes one at a time. */
export function buildTree(geometry: BufferGeometry): Promise<MeshBVH> {
  const build = async () => {
    worker ??= new GenerateMeshBVHWorker();
    // The worker takes the arrays away and gives them back later: it gets copies, which are not kept.
    const tree = await worker.generate(geometry.clone(), { indirect: true });
    for (const [name, attribute] of Object.entries(geometry.attributes)) tree.geometry.setAttribute(name, attribute);
    tree.geometry.setIndex(geometry.index);
    return tree;
  };
  const tree = last.then(build, build);
  last = tree;
  return tree;
}
