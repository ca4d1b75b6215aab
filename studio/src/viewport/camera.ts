/**
 * A camera that turns about a target with z up, in double precision: eye and target are in model coordinates, and
 * only what is drawn is moved near the origin first.
 */

import { MathUtils, OrthographicCamera, PerspectiveCamera, Vector3, type Camera } from "three";

import { centre, cornersOf, radius, union } from "../core/bounds";
import type { Bounds, Point3 } from "../core/preview";

export type Projection = "perspective" | "parallel";

/** What a camera looks like; everything else follows from it. */
export interface Pose {
  target: Point3;
  /** Where the eye stands about the target, in radians: 0 on +x, a quarter turn on +y. */
  azimuth: number;
  /** How high the eye stands, in radians from −½π (below) to ½π (above). */
  elevation: number;
  /** How much of the plane through the target is seen from the bottom to the top of the view, in model units. */
  height: number;
  projection: Projection;
}

const QUARTER = Math.PI / 2;
/** The lens of Rhino's perspective view, 50 mm, as the vertical angle of a 24 mm high picture. */
const FIELD = 2 * Math.atan(12 / 50);
const SMALLEST = 1e-6;
const GREATEST = 1e12;
/** How much of a view geometry fills after zoom extents. */
export const MARGIN = 1.1;
/** Geometry that fills less than this share of a view is framed anew. */
const LEAST_SHARE = 0.3;
/** A flat or tiny model has this share of the view for depth: points and lines are drawn a little before where they are. */
const LEAST_DEPTH = 0.1;
/** What is smaller than this part of its distance from the origin is a point: the rest is rounding. */
const POINTLIKE = 1e-9;
/** How much is seen around a point, in model units: what an empty view shows. */
export const USUAL_HEIGHT = 60;

export class CameraRig {
  pose: Pose;
  readonly #perspective = new PerspectiveCamera();
  readonly #parallel = new OrthographicCamera();

  constructor(pose: Pose) {
    this.pose = pose;
    this.#perspective.up.set(0, 0, 1);
  }

  /** From the target to the eye. */
  backward(): Vector3 {
    const { azimuth, elevation } = this.pose;
    const flat = Math.cos(elevation);
    return new Vector3(flat * Math.cos(azimuth), flat * Math.sin(azimuth), Math.sin(elevation));
  }

  right(): Vector3 {
    const { azimuth } = this.pose;
    return new Vector3(-Math.sin(azimuth), Math.cos(azimuth), 0);
  }

  up(): Vector3 {
    return this.backward().cross(this.right());
  }

  /** How far the eye is from the target. */
  distance(): number {
    return this.pose.height / 2 / Math.tan(FIELD / 2);
  }

  eye(): Vector3 {
    return new Vector3(...this.pose.target).addScaledVector(this.backward(), this.distance());
  }

  /** How many model units a pixel at the target is wide. */
  pixel(viewHeight: number): number {
    return this.pose.height / Math.max(viewHeight, 1);
  }

  orbit(byAzimuth: number, byElevation: number): void {
    const elevation = MathUtils.clamp(this.pose.elevation + byElevation, -QUARTER, QUARTER);
    this.pose = { ...this.pose, azimuth: wrap(this.pose.azimuth + byAzimuth), elevation };
  }

  /** Moves the picture by pixels: right and down. */
  pan(dx: number, dy: number, viewHeight: number): void {
    const pixel = this.pixel(viewHeight);
    const target = new Vector3(...this.pose.target)
      .addScaledVector(this.right(), -dx * pixel)
      .addScaledVector(this.up(), dy * pixel);
    this.pose = { ...this.pose, target: target.toArray() };
  }

  /** Makes everything `factor` times as near to a point, which stays where it is in the picture. */
  zoomAbout(point: Vector3, factor: number): void {
    const height = MathUtils.clamp(this.pose.height * factor, SMALLEST, GREATEST);
    const kept = height / this.pose.height;
    const target = new Vector3(...this.pose.target).sub(point).multiplyScalar(kept).add(point);
    this.pose = { ...this.pose, target: target.toArray(), height };
  }

  /**
   * Shows all of some boxes, as large as the view takes them. In perspective each side of the view is pushed against
   * the corner that reaches it first; where the eye must then be follows from the four sides.
   */
  fit(boxes: readonly Bounds[], aspect: number, margin: number = MARGIN): void {
    const all = boxes.reduce<Bounds | null>(union, null);
    if (!all) return;
    const middle = new Vector3(...centre(all));
    // A point alone has no size to go by: with a view as small as it is, grid and axes would be far out of sight.
    if (radius(all) <= Math.max(middle.length(), 1) * POINTLIKE) {
      this.pose = { ...this.pose, target: middle.toArray(), height: USUAL_HEIGHT };
      return;
    }
    const [right, up, backward] = [this.right(), this.up(), this.backward()];
    const slope = this.pose.projection === "perspective" ? Math.tan(FIELD / 2) : 0;
    const across = side(boxes, middle, right, backward, slope * aspect);
    const along = side(boxes, middle, up, backward, slope);
    const least = Math.max(radius(all) * 2e-3, SMALLEST);
    let half = Math.max(across.half / aspect, along.half, least);
    // For a perspective the halves are those at the middle's depth: the eye's distance times the slope.
    half = Math.max(half, slope > 0 ? radius(all) * 0.05 : 0);
    const target = middle.addScaledVector(right, across.shift).addScaledVector(up, along.shift);
    const height = MathUtils.clamp(2 * half * margin, SMALLEST, GREATEST);
    this.pose = { ...this.pose, target: target.toArray(), height };
  }

  /**
   * Whether some boxes are shown as one would frame them: all of them in the view, and neither too small nor so large
   * that the next change leaves it.
   */
  frames(boxes: readonly Bounds[], aspect: number, margin: number = MARGIN): boolean {
    const fitted = new CameraRig(this.pose);
    fitted.fit(boxes, aspect, margin);
    const [now, wanted] = [this.pose, fitted.pose];
    const off = new Vector3(...now.target).sub(new Vector3(...wanted.target));
    const shift = Math.max(Math.abs(off.dot(this.up())), Math.abs(off.dot(this.right())) / Math.max(aspect, 1));
    const room = now.height - wanted.height / margin - 2 * shift;
    return room >= -1e-9 * now.height && wanted.height >= now.height * LEAST_SHARE;
  }

  /** Where a ray through a place in the view (−1 to 1, y up) starts and goes, in model coordinates. */
  ray(x: number, y: number, aspect: number): { origin: Vector3; direction: Vector3 } {
    const half = this.pose.height / 2;
    const across = new Vector3().addScaledVector(this.right(), x * half * aspect).addScaledVector(this.up(), y * half);
    const target = new Vector3(...this.pose.target);
    if (this.pose.projection === "perspective") {
      const eye = this.eye();
      return { origin: eye, direction: target.add(across).sub(eye).normalize() };
    }
    const backward = this.backward();
    const far = this.distance() * 100;
    return { origin: target.add(across).addScaledVector(backward, far), direction: backward.negate() };
  }

  /** Where a ray meets the plane through the target that faces the eye. */
  onTargetPlane(x: number, y: number, aspect: number): Vector3 {
    const half = this.pose.height / 2;
    return new Vector3(...this.pose.target)
      .addScaledVector(this.right(), x * half * aspect)
      .addScaledVector(this.up(), y * half);
  }

  /** The camera to draw with, for geometry that was moved by −origin; near and far fit the bounds. */
  camera(origin: Point3, bounds: Bounds | null, aspect: number): Camera {
    const { height, projection } = this.pose;
    const camera = projection === "perspective" ? this.#perspective : this.#parallel;
    const backward = this.backward();
    camera.position.copy(this.eye()).sub(new Vector3(...origin));
    camera.matrixAutoUpdate = false;
    camera.matrix.makeBasis(this.right(), this.up(), backward).setPosition(camera.position);
    camera.matrixWorldNeedsUpdate = true;
    const [near, far] = this.#depths(bounds);
    if (camera instanceof PerspectiveCamera) {
      camera.fov = MathUtils.radToDeg(FIELD);
      camera.aspect = aspect;
    } else {
      camera.top = height / 2;
      camera.bottom = -height / 2;
      camera.right = (height / 2) * aspect;
      camera.left = -camera.right;
    }
    camera.near = near;
    camera.far = far;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld(true);
    return camera;
  }

  #depths(bounds: Bounds | null): [near: number, far: number] {
    const distance = this.distance();
    const size = bounds ? Math.max(radius(bounds), this.pose.height * LEAST_DEPTH) : this.pose.height;
    const middle = new Vector3(...(bounds ? centre(bounds) : this.pose.target));
    const along = this.eye().sub(middle).dot(this.backward());
    const [near, far] = [along - size * 1.01, along + size * 1.01];
    if (this.pose.projection === "parallel") return [near, Math.max(far, near + size)];
    // What is nearer than a thousandth of the way to the target or of the depth seen is not drawn.
    const least = Math.max(distance, far) * 1e-3;
    const nearest = Math.max(near, Math.min(least, distance * 0.05));
    return [nearest, Math.max(far, nearest * 2)];
  }
}

/**
 * How far the middle of the view must be shifted along a direction, and half of how much it must show there. The sides
 * of the view lean outwards by `slope` (0: parallel), so what is nearer to the eye than the middle counts for more.
 */
function side(boxes: readonly Bounds[], middle: Vector3, direction: Vector3, backward: Vector3, slope: number) {
  let [least, greatest] = [Infinity, -Infinity];
  for (const box of boxes) {
    for (const corner of cornersOf(box)) {
      const offset = new Vector3(...corner).sub(middle);
      const [place, nearer] = [offset.dot(direction), offset.dot(backward) * slope];
      greatest = Math.max(greatest, place + nearer);
      least = Math.min(least, place - nearer);
    }
  }
  return { shift: (greatest + least) / 2, half: (greatest - least) / 2 };
}

/** An angle between −π and π. */
export function wrap(angle: number): number {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}
