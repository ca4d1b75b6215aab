/** The grid: one triangle over the whole view; each pixel looks where its ray meets the plane. */

export const GRID_VERTEX = /* glsl */ `
precision highp float;
uniform mat4 uToWorld;
in vec3 position;
// Where the ray of a pixel begins and where it goes: both are linear over the view, because all places of one depth have
// the same fourth coordinate in the world.
out vec3 vFrom;
out vec3 vRay;

void main() {
  vec4 near = uToWorld * vec4(position.xy, -1.0, 1.0);
  vec4 far = uToWorld * vec4(position.xy, 1.0, 1.0);
  vFrom = near.xyz / near.w;
  vRay = far.xyz / far.w - vFrom;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`;

export const GRID_FRAGMENT = /* glsl */ `
precision highp float;
// What of a place in the world gives its depth and its fourth coordinate in the view.
uniform vec4 uDepth;
uniform vec4 uWeight;
uniform vec3 uEye;
// The plane: two directions in it and the one across it, and how far it is from the eye's origin.
uniform vec3 uU;
uniform vec3 uV;
uniform vec3 uW;
uniform float uOffset;
// Where the lines are: the model's origin on the plane, less whole steps.
uniform vec2 uStart;
uniform vec2 uAxes;
uniform float uMinor;
uniform float uStrength;
uniform float uReach;
uniform vec3 uMinorColour;
uniform vec3 uMajorColour;
uniform vec3 uUColour;
uniform vec3 uVColour;
in vec3 vFrom;
in vec3 vRay;
layout(location = 0) out vec4 oColour;

float lines(vec2 place, float step_, float width) {
  vec2 at = place / step_;
  vec2 size = fwidth(at);
  vec2 off = abs(fract(at - 0.5) - 0.5);
  vec2 cover = clamp(width * 0.5 + 0.5 - off / max(size, vec2(1e-9)), 0.0, 1.0);
  // Where lines are closer than pixels there is no grid to see.
  cover *= 1.0 - smoothstep(0.25, 0.5, size);
  return max(cover.x, cover.y);
}

float axis(float place, float width) {
  return clamp(width * 0.5 + 0.5 - abs(place) / max(fwidth(place), 1e-9), 0.0, 1.0);
}

void main() {
  float slope = dot(vRay, uW);
  float along = (uOffset - dot(vFrom, uW)) / slope;
  vec3 point = vFrom + vRay * along;
  vec2 place = vec2(dot(point, uU), dot(point, uV));
  float minor = lines(place - uStart, uMinor, 1.0) * uStrength;
  float major = lines(place - uStart, uMinor * 10.0, 1.0);
  float u = axis(place.y - uAxes.y, 1.6);
  float v = axis(place.x - uAxes.x, 1.6);
  float weight = dot(uWeight, vec4(point, 1.0));
  if (abs(slope) < 1e-9 * length(vRay) || weight <= 0.0) discard;
  float fade = 1.0 - smoothstep(uReach * 0.25, uReach, length(point - uEye));
  // Seen nearly along itself the plane is all lines.
  fade *= smoothstep(0.0, 0.12, abs(slope) / length(vRay));
  float cover = max(minor * 0.55, major);
  vec3 colour = mix(uMinorColour, uMajorColour, step(minor * 0.55, major) * major);
  if (u > 0.0) { colour = mix(colour, uUColour, u); cover = max(cover, u); }
  if (v > 0.0) { colour = mix(colour, uVColour, v); cover = max(cover, v); }
  if (cover * fade < 0.004) discard;
  gl_FragDepth = clamp(dot(uDepth, vec4(point, 1.0)) / weight * 0.5 + 0.5, 0.0, 1.0);
  oColour = vec4(colour, cover * fade);
}
`;
