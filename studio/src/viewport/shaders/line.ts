/** Curves, edges and the heads of arrows. */

import { COMMON_VERTEX } from "./common";

/** Lines one pixel wide, as the graphics card draws them: quick where there are many. */
export const THIN_VERTEX = /* glsl */ `
${COMMON_VERTEX}
in vec3 position;
out float vBeyond;

void main() {
  vLook = look();
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  vBeyond = beyond(view.xyz);
  gl_Position = drawn(vLook) ? projectionMatrix * nearer(view) : NOWHERE;
}
`;

/** Lines of any width: each segment is a rectangle that faces the screen. */
export const WIDE_VERTEX = /* glsl */ `
${COMMON_VERTEX}
uniform vec2 uView;
uniform float uWidth;
// x: the side, −1 or 1; y: the end, 0 or 1; z: how far beyond it.
in vec3 position;
in vec3 from;
in vec3 to;
out float vAcross;
out float vHalf;
out float vBeyond;

void main() {
  vLook = look();
  if (!drawn(vLook)) {
    gl_Position = NOWHERE;
    return;
  }
  vec4 a = nearer(modelViewMatrix * vec4(from, 1.0));
  vec4 b = nearer(modelViewMatrix * vec4(to, 1.0));
  // In perspective a segment that starts behind the eye is cut where it comes into sight.
  if (projectionMatrix[3][3] < 0.5) {
    float near = projectionMatrix[3][2] / (projectionMatrix[2][2] - 1.0);
    float limit = -near * 0.999;
    if (a.z > limit && b.z > limit) {
      gl_Position = NOWHERE;
      return;
    }
    if (a.z > limit) a = mix(b, a, (limit - b.z) / (a.z - b.z));
    if (b.z > limit) b = mix(a, b, (limit - a.z) / (b.z - a.z));
  }
  vBeyond = beyond(position.y < 0.5 ? a.xyz : b.xyz);
  vec4 p = projectionMatrix * a;
  vec4 q = projectionMatrix * b;
  vec2 along = (q.xy / q.w - p.xy / p.w) * uView;
  float size = length(along);
  along = size > 1e-6 ? along / size : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  // Half a pixel more on each side for the soft border.
  vHalf = uWidth * 0.5;
  float reach = vHalf + 0.5;
  vAcross = position.x * reach;
  vec4 end = position.y < 0.5 ? p : q;
  vec2 offset = across * vAcross + along * position.z * vHalf;
  end.xy += offset / uView * 2.0 * end.w;
  gl_Position = end;
}
`;

export const LINE_FRAGMENT = /* glsl */ `
precision highp float;
uniform float uFade;
in vec4 vLook;
in float vBeyond;
layout(location = 0) out vec4 oColour;

void main() {
  if (vBeyond > 0.0) discard;
  oColour = vec4(vLook.rgb, vLook.a * uFade);
}
`;

export const WIDE_FRAGMENT = /* glsl */ `
precision highp float;
uniform float uFade;
in vec4 vLook;
in float vAcross;
in float vHalf;
in float vBeyond;
layout(location = 0) out vec4 oColour;

void main() {
  if (vBeyond > 0.0) discard;
  float cover = clamp(vHalf + 0.5 - abs(vAcross), 0.0, 1.0);
  if (cover < 0.02) discard;
  oColour = vec4(vLook.rgb, vLook.a * cover * uFade);
}
`;

/** The heads of arrows: sprites that point where their segment goes on the screen. */
export const HEAD_VERTEX = /* glsl */ `
${COMMON_VERTEX}
uniform vec2 uView;
uniform float uWidth;
in vec3 from;
in vec3 to;
out vec2 vAlong;

void main() {
  vLook = look();
  vec4 a = projectionMatrix * (modelViewMatrix * vec4(from, 1.0));
  vec4 end = modelViewMatrix * vec4(to, 1.0);
  vec4 b = projectionMatrix * nearer(end);
  vec2 along = (b.xy / b.w - a.xy / max(a.w, 1e-6)) * uView * 0.5;
  float size = length(along);
  // Seen along its axis, or shorter than its head, an arrow has a smaller head.
  float head = min(uWidth, size);
  if (!drawn(vLook) || beyond(end.xyz) > 0.0 || a.w <= 0.0 || head < 1.0) {
    gl_Position = NOWHERE;
    return;
  }
  vAlong = along / size;
  gl_PointSize = head * 2.0;
  gl_Position = b;
}
`;

export const HEAD_FRAGMENT = /* glsl */ `
precision highp float;
in vec4 vLook;
in vec2 vAlong;
layout(location = 0) out vec4 oColour;

void main() {
  // The tip is in the middle of the sprite, the head goes back half the sprite.
  vec2 place = vec2(gl_PointCoord.x * 2.0 - 1.0, 1.0 - gl_PointCoord.y * 2.0);
  float back = -dot(place, vAlong);
  float across = abs(dot(place, vec2(-vAlong.y, vAlong.x)));
  if (back < 0.0 || back > 0.95 || across > back * 0.36) discard;
  oColour = vLook;
}
`;
