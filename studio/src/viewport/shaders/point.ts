/** Points: a cross as Grasshopper draws them, and squares for control points. */

import { COMMON_VERTEX } from "./common";

/** What `uShape` says. */
export const SHAPE = { cross: 0, square: 1, dot: 2 } as const;

export const POINT_VERTEX = /* glsl */ `
${COMMON_VERTEX}
uniform float uWidth;
in vec3 position;

void main() {
  vLook = look();
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  gl_Position = drawn(vLook) && beyond(view.xyz) <= 0.0 ? projectionMatrix * nearer(view) : NOWHERE;
  gl_PointSize = uWidth;
}
`;

export const POINT_FRAGMENT = /* glsl */ `
precision highp float;
precision highp int;
uniform float uWidth;
uniform float uStroke;
uniform int uShape;
uniform vec3 uPaper;
in vec4 vLook;
layout(location = 0) out vec4 oColour;

void main() {
  if (uShape == 2) {
    oColour = vLook;
    return;
  }
  vec2 place = (gl_PointCoord - 0.5) * uWidth;
  if (uShape == 0) {
    // A cross with a border of paper, so that it shows on its own colour.
    float arm = min(abs(place.x), abs(place.y));
    if (arm > uStroke * 0.5 + 1.0) discard;
    float cover = clamp(uStroke * 0.5 + 0.5 - arm, 0.0, 1.0);
    if (max(abs(place.x), abs(place.y)) > uWidth * 0.5 - 1.0) cover = 0.0;
    oColour = vec4(mix(uPaper, vLook.rgb, cover), max(cover, 0.55) * vLook.a);
  } else {
    float out_ = max(abs(place.x), abs(place.y));
    float line = uWidth * 0.5 - out_;
    oColour = line < uStroke ? vLook : vec4(uPaper, vLook.a);
  }
}
`;
