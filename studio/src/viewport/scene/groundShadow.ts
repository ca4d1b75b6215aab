/** The soft shadow on the ground below the model, in the rendered mode; made anew when the model changes. */

import {
  Color, GLSL3, LinearFilter, Mesh, NoBlending, OrthographicCamera, RawShaderMaterial, Scene, Vector2, Vector3, WebGLRenderTarget,
  type WebGLRenderer,
} from "three";

import { BLUR_FRAGMENT, FLAT_VERTEX, LAID_FRAGMENT } from "../shaders/shadow";
import { ORDER, SHADOW_LAYER } from "./drawable";
import type { Model } from "./model";
import { square } from "./screen";

const SIZE = 512;
/** How much wider the shadow may be than the model, for its soft border. */
const WIDER = 1.35;
const DARKNESS = 0.55;

export class GroundShadow {
  readonly mesh: Mesh;
  #targets: [WebGLRenderTarget, WebGLRenderTarget];
  #camera = new OrthographicCamera();
  #blur: RawShaderMaterial;
  #laid: RawShaderMaterial;
  #screen = new Scene();

  constructor() {
    const target = () => new WebGLRenderTarget(SIZE, SIZE, { minFilter: LinearFilter, magFilter: LinearFilter });
    this.#targets = [target(), target()];
    this.#blur = flat(BLUR_FRAGMENT, true, { uStep: { value: new Vector2() } });
    this.#blur.blending = NoBlending;
    this.#laid = flat(LAID_FRAGMENT, false, { uDarkness: { value: DARKNESS } });
    this.mesh = new Mesh(square(), this.#laid);
    this.mesh.matrixAutoUpdate = false;
    this.mesh.renderOrder = ORDER.grid + 0.5;
    this.#screen.add(new Mesh(square(), this.#blur));
    this.#camera.layers.set(SHADOW_LAYER);
    this.#camera.matrixAutoUpdate = false;
  }

  /** Draws the shadow of the model as it is now. */
  update(renderer: WebGLRenderer, model: Model): void {
    this.mesh.visible = model.bounds !== null;
    if (!model.bounds) return;
    const [[a, b, c], [d, e, f]] = model.bounds;
    const [x, y, z] = model.origin;
    const least = Math.max(d - a, e - b, f - c, 1e-6) * 0.2;
    const [width, depth] = [Math.max((d - a) * WIDER, least), Math.max((e - b) * WIDER, least)];
    const height = Math.max(f - c, least);
    const middle = new Vector3((a + d) / 2 - x, (b + e) / 2 - y, c - z);
    const camera = this.#camera;
    // From below the model looking up, with x to the right as the square has it: y then runs the other way.
    camera.matrix.makeBasis(new Vector3(1, 0, 0), new Vector3(0, -1, 0), new Vector3(0, 0, -1));
    camera.matrix.setPosition(middle.x, middle.y, middle.z - height * 0.01);
    camera.matrixWorldNeedsUpdate = true;
    [camera.left, camera.right, camera.bottom, camera.top] = [-width / 2, width / 2, -depth / 2, depth / 2];
    [camera.near, camera.far] = [0, height * 1.1];
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld(true);
    const reach = model.materials.shadow.uniforms["uReach"];
    if (reach) reach.value = height;
    this.#draw(renderer, model, width, depth);
    this.mesh.matrix.makeScale(width / 2, -depth / 2, 1).setPosition(middle.x, middle.y, middle.z - height * 1e-3);
    this.mesh.matrixWorldNeedsUpdate = true;
  }

  dispose(): void {
    for (const target of this.#targets) target.dispose();
    this.#blur.dispose();
    this.#laid.dispose();
    this.mesh.geometry.dispose();
  }

  #draw(renderer: WebGLRenderer, model: Model, width: number, depth: number): void {
    const [first, second] = this.#targets;
    const before = renderer.getClearColor(new Color());
    renderer.setScissorTest(false);
    renderer.setClearColor(0x000000, 0);
    renderer.setRenderTarget(first);
    renderer.clear();
    renderer.render(model.scene, this.#camera);
    const longest = Math.max(width, depth);
    // Twice, each time along x and y: softer, and as soft in both directions.
    for (const spread of [1.6, 2.4]) {
      this.#pass(renderer, first, second, spread * (longest / width), 0);
      this.#pass(renderer, second, first, 0, spread * (longest / depth));
    }
    renderer.setRenderTarget(null);
    renderer.setClearColor(before, 1);
    renderer.setScissorTest(true);
    this.#laid.uniforms["uPicture"]!.value = first.texture;
  }

  #pass(renderer: WebGLRenderer, from: WebGLRenderTarget, to: WebGLRenderTarget, x: number, y: number): void {
    this.#blur.uniforms["uPicture"]!.value = from.texture;
    (this.#blur.uniforms["uStep"]!.value as Vector2).set(x / SIZE / 2, y / SIZE / 2);
    this.#blur.uniformsNeedUpdate = true;
    renderer.setRenderTarget(to);
    renderer.render(this.#screen, SCREEN);
  }
}

const SCREEN = new OrthographicCamera();

function flat(fragmentShader: string, isScreen: boolean, own: RawShaderMaterial["uniforms"]): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: FLAT_VERTEX,
    fragmentShader,
    side: 2,
    transparent: true,
    depthWrite: false,
    depthTest: !isScreen,
    uniforms: { uPicture: { value: null }, uIsScreen: { value: isScreen }, ...own },
  });
}
