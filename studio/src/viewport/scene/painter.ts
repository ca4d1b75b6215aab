/** Draws the model into a pane, as the settings say. */

import { Color, Matrix4, Scene, SRGBColorSpace, Vector3, type Camera, type WebGLRenderer } from "three";

import type { PlacedPane } from "../panes";
import type { ViewportSettings } from "../settings";
import { SHADE } from "../shaders/mesh";
import { SKY_FRAGMENT } from "../shaders/occlusion";
import type { Theme } from "../theme";
import { Grid } from "./grid";
import { GroundShadow } from "./groundShadow";
import type { Model } from "./model";
import { Occlusion } from "./occlusion";
import { Screen } from "./screen";

/** How much of ghosted surfaces is there. */
const GHOST = 0.55;

/** What is drawn of a picture: all of it, what the model stands before, or the model on nothing. */
export type Layer = "all" | "ground" | "model";

export class Painter {
  #renderer: WebGLRenderer;
  #model: Model;
  #grid = new Grid();
  /** The grid without the model. */
  #ground = new Scene();
  #shadow = new GroundShadow();
  /** What the shadow was made of. */
  #shadowOf = "";
  #occlusion = new Occlusion();
  #sky = new Screen(SKY_FRAGMENT, {
    uUnproject: { value: new Matrix4() }, uToWorld: { value: new Matrix4() },
    uHigh: { value: new Vector3() }, uHorizon: { value: new Vector3() }, uLow: { value: new Vector3() },
  });
  #isRendered = false;
  #isQuick = false;
  #background = new Color();
  #isGridShown = true;
  #theme: Theme | undefined;

  constructor(renderer: WebGLRenderer, model: Model) {
    this.#renderer = renderer;
    this.#model = model;
    model.scene.add(this.#grid.mesh, this.#shadow.mesh);
    this.#ground.add(this.#grid.mesh.clone());
  }

  /** Makes ready for a picture of all panes. A quick one does not sort out what is behind what in one surface. */
  prepare(settings: ViewportSettings, theme: Theme, range: readonly [number, number] | undefined, isQuick: boolean): void {
    const { analysis, mode, stripes, across, shown } = settings;
    const { shared, translucent, quick } = this.#model.materials;
    const isPaper = mode === "technical" && analysis === "none";
    const isGhosted = mode === "ghosted" && analysis === "none";
    shared.uShade.value = shadeOf(settings);
    shared.uRange.value.set(range?.[0] ?? 0, range?.[1] ?? 1);
    shared.uStripes.value = stripes;
    shared.uStripesAcross.value = across ? 1 : 0;
    shared.uPaper.value.copy(theme.paper);
    shared.uInk.value.copy(theme.inkVector);
    shared.uAlpha.value = isGhosted ? GHOST : 1;
    for (const material of [translucent, quick.translucent]) material.depthWrite = !isGhosted;
    const isSolid = isPaper || analysis !== "none";
    this.#model.materials.isQuick = isQuick;
    this.#model.choosePasses(isSolid ? "solid" : isGhosted ? "through" : "own", !isQuick);
    this.#isRendered = mode === "rendered" && analysis === "none";
    this.#isQuick = isQuick;
    // A rendered model stands under a sky, not on a grid.
    this.#isGridShown = shown.grid && !this.#isRendered;
    this.#theme = theme;
    const { x, y, z } = isPaper ? theme.paper : theme.background;
    this.#background.setRGB(x, y, z, SRGBColorSpace);
    this.#paintSky(theme);
    this.#castShadow(this.#isRendered && !isQuick);
    this.#renderer.setScissorTest(true);
  }

  #paintSky({ background }: Theme): void {
    const towards = (x: number, y: number, z: number, share: number) => background.clone().lerp(new Vector3(x, y, z), share);
    const isDark = background.x + background.y + background.z < 1.2;
    this.#sky.set({
      uHigh: isDark ? towards(0.05, 0.09, 0.16, 0.6) : towards(0.56, 0.7, 0.86, 0.75),
      uHorizon: isDark ? towards(0.3, 0.34, 0.4, 0.55) : towards(1, 1, 1, 0.8),
      uLow: isDark ? towards(0.08, 0.085, 0.09, 0.5) : towards(0.8, 0.79, 0.77, 0.6),
    });
  }

  #castShadow(isCast: boolean): void {
    const { mesh } = this.#shadow;
    mesh.visible = isCast;
    const now = `${this.#model.version} ${this.#model.table.version}`;
    if (!isCast) return;
    if (now === this.#shadowOf) {
      mesh.visible = this.#model.bounds !== null;
      return;
    }
    // Not while it is made: it would darken itself.
    mesh.visible = false;
    this.#shadow.update(this.#renderer, this.#model);
    this.#shadowOf = now;
  }

  /** What the ground looks like, but for where it is looked at from. */
  groundLook(): string {
    return `${this.#background.getHexString()} ${this.#isGridShown} ${this.#isRendered}`;
  }

  /** Whether what is behind surfaces cannot be drawn before all of them: some hide the grid, and the grid some of them. */
  isGroundBetween(): boolean {
    return this.#isGridShown && this.#model.hides;
  }

  /** Draws one pane; `canvasHeight` because the card counts rows from below. */
  paint({ left, top, width, height, pane }: PlacedPane, camera: Camera, canvasHeight: number, layer: Layer = "all"): void {
    const bottom = canvasHeight - top - height;
    this.#renderer.setViewport(left, bottom, width, height);
    this.#renderer.setScissor(left, bottom, width, height);
    this.#renderer.setClearColor(this.#background, layer === "model" ? 0 : 1);
    this.#renderer.clear();
    if (this.#isRendered && layer !== "model") {
      this.#sky.set({ uUnproject: camera.projectionMatrixInverse, uToWorld: camera.matrixWorld });
      this.#sky.draw(this.#renderer);
    }
    const ratio = this.#renderer.getPixelRatio();
    this.#model.materials.shared.uView.value.set(width * ratio, height * ratio);
    this.#grid.mesh.visible = this.#isGridShown && layer === "all";
    if (this.#theme && layer !== "model") this.#grid.prepare(pane.rig, camera, this.#model.origin, height, this.#theme.grid);
    if (layer === "ground") {
      if (this.#isGridShown) this.#renderer.render(this.#ground, camera);
      return;
    }
    this.#cut(camera);
    this.#model.sortSurfaces(camera.matrixWorldInverse);
    this.#renderer.render(this.#model.scene, camera);
    if (this.#isRendered && !this.#isQuick) this.#occlusion.apply(this.#renderer, this.#model, camera, { left, bottom, width, height });
  }

  /** Says where the view is cut: in the coordinates of the eye. */
  #cut(camera: Camera): void {
    const plane = this.#model.materials.shared.uSection.value;
    const { section } = this.#model;
    if (!section) {
      plane.set(0, 0, 0, -1);
      return;
    }
    const { normal, at } = section;
    const across = new Vector3(...normal);
    // A point of the plane, where drawing has it.
    const on = across.clone().multiplyScalar(at).sub(new Vector3(...this.#model.origin)).applyMatrix4(camera.matrixWorldInverse);
    across.transformDirection(camera.matrixWorldInverse);
    plane.set(across.x, across.y, across.z, -across.dot(on));
  }

  /** Makes the shadow anew: the graphics card forgot it. */
  forget(): void {
    this.#shadowOf = "";
  }

  dispose(): void {
    this.#grid.dispose();
    this.#occlusion.dispose();
    this.#sky.dispose();
    this.#shadow.dispose();
  }
}

function shadeOf({ analysis, mode }: ViewportSettings): number {
  if (analysis === "zebra") return SHADE.zebra;
  if (analysis !== "none") return SHADE.falseColour;
  if (mode === "rendered") return SHADE.rendered;
  return mode === "technical" ? SHADE.technical : SHADE.shaded;
}
