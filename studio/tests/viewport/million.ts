/** A mesh of a million triangles, and the least that drawing it takes. */

import {
  BufferAttribute, BufferGeometry, DoubleSide, HemisphereLight, Mesh, MeshLambertMaterial, PerspectiveCamera, Raycaster, Scene, Vector2,
  WebGLRenderer,
} from "three";

import { currentViewport } from "../../src/viewport";
import { surface, type Grid } from "../unit/shapes";

const SIDE = 706;

export function million(phase: number): Grid {
  return surface(SIDE, SIDE, (u, v) => {
    const [x, y] = [u * 20 - 10, v * 20 - 10];
    const [dx, dy] = [Math.cos(x + phase) * Math.cos(y), -Math.sin(x + phase) * Math.sin(y)];
    const length = Math.hypot(dx, dy, 1);
    return { point: [x, y, Math.sin(x + phase) * Math.cos(y)], normal: [-dx / length, -dy / length, 1 / length] };
  });
}

/** Draws meshes with nothing but three.js; gives how long one takes from its arrays to the picture. */
export function floor(): (mesh: Grid) => number {
  const canvas = document.createElement("canvas");
  const renderer = new WebGLRenderer({ canvas });
  renderer.setSize(640, 480, false);
  const camera = new PerspectiveCamera(27, 640 / 480, 1, 200);
  camera.up.set(0, 0, 1);
  camera.position.set(-18, -31, 21);
  camera.lookAt(0, 0, 0);
  const scene = new Scene();
  scene.add(new HemisphereLight(0xffffff, 0x333333, 3));
  const material = new MeshLambertMaterial({ color: 0x960000, side: DoubleSide });
  let before: Mesh | undefined;
  return (mesh) => {
    const start = performance.now();
    const geometry = geometryOf(mesh);
    if (before) scene.remove(before);
    before?.geometry.dispose();
    before = new Mesh(geometry, material);
    scene.add(before);
    renderer.render(scene, camera);
    const gl = renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    return performance.now() - start;
  };
}

/** How long a pick takes through the tree, through all triangles, and how long drawing everything once takes. */
export function timePick(x: number, y: number): { tree: number; brute: number; draw: number } {
  const viewport = currentViewport();
  if (!viewport) return { tree: NaN, brute: NaN, draw: NaN };
  const placed = viewport.panes.at(x, y);
  const { camera, width, height } = viewport.viewOf(placed);
  const count = 200;
  let start = performance.now();
  for (let at = 0; at < count; at++) viewport.pickAt(x + (at % 20), y);
  const tree = (performance.now() - start) / count;
  const mesh = new Mesh(geometryOf(million(0)), new MeshLambertMaterial({ side: DoubleSide }));
  const ray = new Raycaster();
  ray.setFromCamera(new Vector2((x / width) * 2 - 1, 1 - (y / height) * 2), camera as PerspectiveCamera);
  start = performance.now();
  ray.intersectObject(mesh);
  const brute = performance.now() - start;
  return { tree, brute, draw: window.__studio?.viewport?.draw() ?? NaN };
}

function geometryOf({ positions, normals, indices }: Grid): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  return geometry;
}
