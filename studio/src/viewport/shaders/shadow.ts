/** The soft shadow that a model throws on the ground below it: how near things are to the ground, blurred. */

import { COMMON_VERTEX } from "./common";

export const SHADOW_VERTEX = /* glsl */ `
${COMMON_VERTEX}
in vec3 position;
out float vHeight;

void main() {
  vLook = look();
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  // The camera looks up from the ground: what is deep is high.
  vHeight = -view.z;
  gl_Position = drawn(vLook) ? projectionMatrix * view : NOWHERE;
}
`;

export const SHADOW_FRAGMENT = /* glsl */ `
precision highp float;
uniform float uReach;
in vec4 vLook;
in float vHeight;
layout(location = 0) out vec4 oColour;

void main() {
  float near = 1.0 - clamp(vHeight / uReach, 0.0, 1.0);
  // Even what is high throws some shadow; what shines through throws less.
  oColour = vec4(0.0, 0.0, 0.0, (0.25 + 0.75 * near * near) * mix(0.4, 1.0, vLook.a));
}
`;

export const FLAT_VERTEX = /* glsl */ `
precision highp float;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform bool uIsScreen;
in vec3 position;
out vec2 vPlace;

void main() {
  vPlace = position.xy * 0.5 + 0.5;
  gl_Position = uIsScreen ? vec4(position.xy, 0.0, 1.0) : projectionMatrix * (modelViewMatrix * vec4(position, 1.0));
}
`;

export const BLUR_FRAGMENT = /* glsl */ `
precision highp float;
uniform sampler2D uPicture;
uniform vec2 uStep;
in vec2 vPlace;
layout(location = 0) out vec4 oColour;

void main() {
  float sum = 0.0;
  float all = 0.0;
  for (int at = -8; at <= 8; at++) {
    float weight = exp(-float(at * at) / 26.0);
    sum += texture(uPicture, vPlace + uStep * float(at)).a * weight;
    all += weight;
  }
  oColour = vec4(0.0, 0.0, 0.0, sum / all);
}
`;

export const LAID_FRAGMENT = /* glsl */ `
precision highp float;
uniform sampler2D uPicture;
uniform float uDarkness;
in vec2 vPlace;
layout(location = 0) out vec4 oColour;

void main() {
  oColour = vec4(0.0, 0.0, 0.0, texture(uPicture, vPlace).a * uDarkness);
}
`;
