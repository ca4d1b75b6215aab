/** The grid of a view: a plane through the model's origin, as fine as the view shows it well. */

import { BufferAttribute, BufferGeometry, GLSL3, Matrix4, Mesh, RawShaderMaterial, Sphere, Vector2, Vector3, Vector4, type Camera } from "three";

import { gridSteps } from "../../core/gridSteps";
import type { Point3 } from "../../core/preview";
import type { CameraRig } from "../camera";
import { GRID_FRAGMENT, GRID_VERTEX } from "../shaders/grid";
import { gridPlane, type GridPlane } from "../views";
import { ORDER } from "./drawable";

export interface GridColours {
  minor: Vector3;
  major: Vector3;
  x: Vector3;
  y: Vector3;
  z: Vector3;
}

const PLANES: Record<GridPlane, { u: 0 | 1 | 2; v: 0 | 1 | 2; w: 0 | 1 | 2 }> = {
  xy: { u: 0, v: 1, w: 2 },
  xz: { u: 0, v: 2, w: 1 },
  yz: { u: 1, v: 2, w: 0 },
};
const NAMES = ["x", "y", "z"] as const;
/** How many view heights around the eye the grid reaches. */
const REACH = 6;

export class Grid {
  readonly mesh: Mesh;
  #material: RawShaderMaterial;

  constructor() {
    const geometry = new BufferGeometry();
    // One triangle that covers the view.
    geometry.setAttribute("position", new BufferAttribute(Float32Array.from([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    const value = (initial: unknown) => ({ value: initial });
    this.#material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: GRID_VERTEX,
      fragmentShader: GRID_FRAGMENT,
      transparent: true,
      depthWrite: false,
      uniforms: {
        uToWorld: value(new Matrix4()), uDepth: value(new Vector4()), uWeight: value(new Vector4()), uEye: value(new Vector3()),
        uU: value(new Vector3()), uV: value(new Vector3()), uW: value(new Vector3()), uOffset: value(0),
        uStart: value(new Vector2()), uAxes: value(new Vector2()), uMinor: value(1), uStrength: value(1), uReach: value(1),
        uMinorColour: value(new Vector3()), uMajorColour: value(new Vector3()),
        uUColour: value(new Vector3()), uVColour: value(new Vector3()),
      },
    });
    this.mesh = new Mesh(geometry, this.#material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = ORDER.grid;
  }

  /** Prepares it for a view whose geometry is drawn moved by −origin. */
  prepare(rig: CameraRig, camera: Camera, origin: Point3, viewHeight: number, colours: GridColours): void {
    const uniforms = this.#material.uniforms;
    const { u, v, w } = PLANES[gridPlane(rig.pose)];
    const unit = (axis: number) => new Vector3().setComponent(axis, 1);
    const toView = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const { minor, major, strength } = gridSteps(rig.pixel(viewHeight));
    // Only the rest after whole thick steps matters for where lines are: single precision is enough for that.
    const start = new Vector2(-(origin[u] % major), -(origin[v] % major));
    const set: Record<string, unknown> = {
      uToWorld: toView.clone().invert(), uDepth: row(toView, 2), uWeight: row(toView, 3), uEye: new Vector3(...rig.pose.target).sub(new Vector3(...origin)),
      uU: unit(u), uV: unit(v), uW: unit(w), uOffset: -origin[w], uStart: start,
      uAxes: new Vector2(-origin[u], -origin[v]), uMinor: minor, uStrength: strength, uReach: rig.pose.height * REACH,
      uMinorColour: colours.minor, uMajorColour: colours.major,
      uUColour: colours[NAMES[u]], uVColour: colours[NAMES[v]],
    };
    for (const [name, next] of Object.entries(set)) uniforms[name]!.value = next;
    this.#material.uniformsNeedUpdate = true;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.#material.dispose();
  }
}

function row({ elements }: Matrix4, at: number): Vector4 {
  return new Vector4(elements[at], elements[at + 4], elements[at + 8], elements[at + 12]);
}
