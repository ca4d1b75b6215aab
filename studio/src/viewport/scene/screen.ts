/** A square that covers the picture, for what is worked out pixel by pixel. */

import { BufferAttribute, BufferGeometry, GLSL3, Mesh, NoBlending, OrthographicCamera, RawShaderMaterial, Scene, Sphere, type WebGLRenderer } from "three";

import { FLAT_VERTEX } from "../shaders/shadow";

const CAMERA = new OrthographicCamera();

export class Screen {
  readonly material: RawShaderMaterial;
  #scene = new Scene();
  #mesh: Mesh;

  constructor(fragmentShader: string, uniforms: RawShaderMaterial["uniforms"]) {
    this.material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: FLAT_VERTEX,
      fragmentShader,
      depthTest: false,
      depthWrite: false,
      blending: NoBlending,
      uniforms: { uIsScreen: { value: true }, ...uniforms },
    });
    this.#mesh = new Mesh(square(), this.material);
    this.#scene.add(this.#mesh);
  }

  set(values: Record<string, unknown>): void {
    for (const [name, value] of Object.entries(values)) this.material.uniforms[name]!.value = value;
    this.material.uniformsNeedUpdate = true;
  }

  draw(renderer: WebGLRenderer): void {
    renderer.render(this.#scene, CAMERA);
  }

  dispose(): void {
    this.#mesh.geometry.dispose();
    this.material.dispose();
  }
}

/** From −1 to 1 in x and y. */
export function square(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3));
  geometry.setIndex(new BufferAttribute(Uint16Array.from([0, 1, 2, 0, 2, 3]), 1));
  geometry.boundingSphere = new Sphere(undefined, Infinity);
  return geometry;
}
