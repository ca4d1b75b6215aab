/** Estimates curvatures beside the page. */

import { estimateCurvatures } from "../../core/curvature";

export interface CurvatureQuestion {
  id: number;
  positions: Float32Array;
  normals: Float32Array | Int8Array;
  indices: Uint16Array | Uint32Array | null;
}

export interface CurvatureAnswer {
  id: number;
  gaussian: Float32Array;
  mean: Float32Array;
}

addEventListener("message", ({ data }: MessageEvent<CurvatureQuestion>) => {
  const { gaussian, mean } = estimateCurvatures(data.positions, data.normals, data.indices);
  const answer: CurvatureAnswer = { id: data.id, gaussian, mean };
  postMessage(answer, { transfer: [gaussian.buffer, mean.buffer] });
});
