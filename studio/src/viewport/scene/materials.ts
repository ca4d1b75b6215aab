/** The materials, each once: what differs between two things drawn is set just before each is drawn. */

import {
  DataTexture, DoubleSide, GLSL3, LessEqualDepth, LinearFilter, NormalBlending, RawShaderMaterial, RGBAFormat, UnsignedByteType,
  Vector2, Vector3, Vector4, type IUniform
} from "three";

import { colourRamp } from "../../core/falseColour";
import type { ColourTable } from "./colourTable";
import { HEAD_FRAGMENT, HEAD_VERTEX, LINE_FRAGMENT, THIN_VERTEX, WIDE_FRAGMENT, WIDE_VERTEX } from "../shaders/line";
import { MESH_FRAGMENT, MESH_VERTEX, QUICK_FRAGMENT, QUICK_VERTEX } from "../shaders/mesh";
import { SHADOW_FRAGMENT, SHADOW_VERTEX } from "../shaders/shadow";
import { POINT_FRAGMENT, POINT_VERTEX } from "../shaders/point";

/** What is the same for everything drawn in one frame. */
export interface SharedUniforms {
  uTable: IUniform<DataTexture>;
  uView: IUniform<Vector2>;
  uNear: IUniform<number>;
  uShade: IUniform<number>;
  uAlpha: IUniform<number>;
  uRange: IUniform<Vector2>;
  uRamp: IUniform<DataTexture>;
  uStripes: IUniform<number>;
  uStripesAcross: IUniform<number>;
  uPaper: IUniform<Vector3>;
  uInk: IUniform<Vector3>;
  /** The plane that cuts the view, in the coordinates of the eye. */
  uSection: IUniform<Vector4>;
  [name: string]: IUniform;
}

const RAMP = 256;

function sharedUniforms(table: IUniform<DataTexture>): SharedUniforms {
  const ramp = new DataTexture(colourRamp(RAMP), RAMP, 1, RGBAFormat, UnsignedByteType);
  ramp.minFilter = LinearFilter;
  ramp.magFilter = LinearFilter;
  ramp.needsUpdate = true;
  return {
    uTable: table,
    uView: { value: new Vector2(1, 1) },
    uNear: { value: 1e-3 },
    uShade: { value: 0 },
    uAlpha: { value: 1 },
    uRange: { value: new Vector2(0, 1) },
    uRamp: { value: ramp },
    uStripes: { value: 12 },
    uStripesAcross: { value: 0 },
    uPaper: { value: new Vector3(1, 1, 1) },
    uInk: { value: new Vector3() },
    uSection: { value: new Vector4(0, 0, 0, -1) },
  };
}

export class Materials {
  readonly shared: SharedUniforms;
  /** Whether the picture is a quick one. */
  isQuick = false;
  readonly #table: ColourTable;
  /** Surfaces that hide what is behind them. */
  readonly opaque: RawShaderMaterial;
  /** Only the depth of surfaces that shine through: after it only the nearest of them are seen. */
  readonly depth: RawShaderMaterial;
  readonly translucent: RawShaderMaterial;
  /** Both in quick pictures, shaded or rendered. */
  readonly quick: { opaque: RawShaderMaterial; translucent: RawShaderMaterial };
  readonly thin: RawShaderMaterial;
  readonly wide: RawShaderMaterial;
  readonly head: RawShaderMaterial;
  readonly points: RawShaderMaterial;
  /** Surfaces as the ground sees them. */
  readonly shadow: RawShaderMaterial;

  constructor(table: ColourTable) {
    this.#table = table;
    this.shared = sharedUniforms(table.uniform);
    const mesh = (pass: number) => this.#make(MESH_VERTEX, MESH_FRAGMENT, pass, { uHas: { value: 0 } });
    const quick = (pass: number) => this.#make(QUICK_VERTEX, QUICK_FRAGMENT, pass, { uHas: { value: 0 } });
    this.opaque = mesh(0);
    this.depth = mesh(1);
    this.translucent = mesh(1);
    this.quick = { opaque: quick(0), translucent: quick(1) };
    // The canvas may be transparent where nothing is drawn.
    for (const material of [this.opaque, this.quick.opaque]) material.defines = { HIDES: "" };
    for (const material of [this.opaque, this.depth, this.translucent, this.quick.opaque, this.quick.translucent]) {
      material.polygonOffset = true;
      material.polygonOffsetFactor = 1;
      material.polygonOffsetUnits = 1;
    }
    this.depth.colorWrite = false;
    this.depth.transparent = true;
    for (const material of [this.translucent, this.quick.translucent]) {
      material.transparent = true;
      material.depthFunc = LessEqualDepth;
    }
    this.shadow = this.#make(SHADOW_VERTEX, SHADOW_FRAGMENT, 2, { uReach: { value: 1 } });
    const line = (vertex: string, fragment: string) => {
      const material = this.#make(vertex, fragment, 2, { uWidth: { value: 1 }, uFade: { value: 1 } });
      material.transparent = true;
      material.depthWrite = false;
      return material;
    };
    this.thin = line(THIN_VERTEX, LINE_FRAGMENT);
    this.wide = line(WIDE_VERTEX, WIDE_FRAGMENT);
    this.head = line(HEAD_VERTEX, HEAD_FRAGMENT);
    this.points = this.#make(POINT_VERTEX, POINT_FRAGMENT, 2, {
      uWidth: { value: 9 },
      uStroke: { value: 1 },
      uShape: { value: 0 },
    });
    this.points.transparent = true;
    this.points.depthWrite = false;
  }

  /** Sets the colour of what is drawn next: that of one place in the table, or of each position's own. */
  setLook(material: RawShaderMaterial, slots: number | Uint16Array): void {
    const { uLook, uIsBatch } = material.uniforms;
    if (!uLook || !uIsBatch) return;
    uIsBatch.value = typeof slots !== "number";
    if (typeof slots === "number") {
      const [red, green, blue, alpha] = this.#table.get(slots);
      (uLook.value as Vector4).set(red, green, blue, alpha).divideScalar(255);
    }
    material.uniformsNeedUpdate = true;
  }

  dispose(): void {
    const { opaque, translucent } = this.quick;
    for (const material of [opaque, translucent, this.opaque, this.depth, this.translucent, this.thin, this.wide, this.head, this.points, this.shadow]) {
      material.dispose();
    }
    this.shared.uRamp.value.dispose();
  }

  #make(vertexShader: string, fragmentShader: string, pass: number, own: Record<string, IUniform>): RawShaderMaterial {
    const uniforms = { ...this.shared, uLook: { value: new Vector4() }, uIsBatch: { value: false }, uPass: { value: pass }, ...own };
    const material = new RawShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, side: DoubleSide });
    material.blending = NormalBlending;
    return material;
  }
}
