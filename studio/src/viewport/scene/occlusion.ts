/** Ambient occlusion of the rendered mode: surfaces are darker where others are near. Of fine pictures alone. */

import {
  AddEquation, Color, CustomBlending, DepthTexture, LinearFilter, Matrix4, NearestFilter, OneFactor, SrcColorFactor, UnsignedIntType, Vector2,
  WebGLRenderTarget, ZeroFactor, type Camera, type WebGLRenderer,
} from "three";

import { radius } from "../../core/bounds";
import { DARKEN_FRAGMENT, OCCLUSION_FRAGMENT } from "../shaders/occlusion";
import { DEPTH_LAYER } from "./drawable";
import type { Model } from "./model";
import { Screen } from "./screen";

/** How far things darken each other, in sizes of the model. */
const REACH = 0.12;
/** The picture of depths is so much smaller along each side. */
const SHARE = 0.5;

/** Where a pane is on the canvas, in pixels of the page from the bottom left. */
export interface Rectangle {
  left: number;
  bottom: number;
  width: number;
  height: number;
}

export class Occlusion {
  #depths: WebGLRenderTarget;
  #shade: WebGLRenderTarget;
  #look = new Screen(OCCLUSION_FRAGMENT, {
    uDepth: { value: null }, uUnproject: { value: new Matrix4() }, uProject: { value: new Matrix4() }, uReach: { value: 1 },
  });
  #darken = new Screen(DARKEN_FRAGMENT, { uPicture: { value: null }, uDepth: { value: null }, uStep: { value: new Vector2() } });

  constructor() {
    this.#depths = new WebGLRenderTarget(1, 1, { minFilter: NearestFilter, magFilter: NearestFilter });
    this.#depths.depthTexture = new DepthTexture(1, 1, UnsignedIntType);
    this.#shade = new WebGLRenderTarget(1, 1, { minFilter: LinearFilter, magFilter: LinearFilter, depthBuffer: false });
    // What is there times the shade; how much of it is there stays.
    Object.assign(this.#darken.material, {
      transparent: true, blending: CustomBlending, blendEquation: AddEquation,
      blendSrc: ZeroFactor, blendDst: SrcColorFactor, blendSrcAlpha: ZeroFactor, blendDstAlpha: OneFactor,
    });
  }

  /** Darkens what was drawn of the model in a pane. */
  apply(renderer: WebGLRenderer, model: Model, camera: Camera, { left, bottom, width, height }: Rectangle): void {
    if (!model.bounds) return;
    const ratio = renderer.getPixelRatio() * SHARE;
    const [columns, rows] = [Math.max(Math.round(width * ratio), 1), Math.max(Math.round(height * ratio), 1)];
    this.#depths.setSize(columns, rows);
    this.#shade.setSize(columns, rows);
    const before = renderer.getClearColor(new Color());
    const alpha = renderer.getClearAlpha();
    renderer.setScissorTest(false);
    renderer.setRenderTarget(this.#depths);
    renderer.clear();
    const mask = camera.layers.mask;
    camera.layers.set(DEPTH_LAYER);
    renderer.render(model.scene, camera);
    camera.layers.mask = mask;
    const uDepth = this.#depths.depthTexture;
    this.#look.set({ uDepth, uProject: camera.projectionMatrix, uUnproject: camera.projectionMatrixInverse, uReach: radius(model.bounds) * 2 * REACH });
    renderer.setRenderTarget(this.#shade);
    this.#look.draw(renderer);
    renderer.setRenderTarget(null);
    renderer.setClearColor(before, alpha);
    renderer.setScissorTest(true);
    renderer.setViewport(left, bottom, width, height);
    renderer.setScissor(left, bottom, width, height);
    this.#darken.set({ uPicture: this.#shade.texture, uDepth, uStep: new Vector2(1 / columns, 1 / rows) });
    this.#darken.draw(renderer);
  }

  dispose(): void {
    this.#depths.dispose();
    this.#shade.dispose();
    this.#look.dispose();
    this.#darken.dispose();
  }
}
