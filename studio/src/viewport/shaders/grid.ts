/** The grid: one triangle over the whole view; each pixel looks where its ray meets the plane. */

export const GRID_VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
out vec2 vPlace;

void main() {
  vPlace = position.xy;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`;

export const GRID_FRAGMENT = /* glsl */ `
precision highp float;
uniform mat4 uToWorld;
uniform mat4 uToView;
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
in vec2 vPlace;
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
  vec4 a = uToWorld * vec4(vPlace, -1.0, 1.0);
  vec4 b = uToWorld * vec4(vPlace, 1.0, 1.0);
  vec3 from = a.xyz / a.w;
  vec3 ray = b.xyz / b.w - from;
  float slope = dot(ray, uW);
  float along = (uOffset - dot(from, uW)) / slope;
  vec3 point = from + ray * along;
  vec2 place = vec2(dot(point, uU), dot(point, uV));
  float minor = lines(place - uStart, uMinor, 1.0) * uStrength;
  float major = lines(place - uStart, uMinor * 10.0, 1.0);
  float u = axis(place.y - uAxes.y, 1.6);
  float v = axis(place.x - uAxes.x, 1.6);
  vec4 clip = uToView * vec4(point, 1.0);
  if (abs(slope) < 1e-9 * length(ray) || clip.w <= 0.0) discard;
  float fade = 1.0 - smoothstep(uReach * 0.25, uReach, length(point - uEye));
  // Seen nearly along itself the plane is all lines.
  fade *= smoothstep(0.0, 0.12, abs(slope) / length(ray));
  float cover = max(minor * 0.55, major);
  vec3 colour = mix(uMinorColour, uMajorColour, step(minor * 0.55, major) * major);
  if (u > 0.0) { colour = mix(colour, uUColour, u); cover = max(cover, u); }
  if (v > 0.0) { colour = mix(colour, uVColour, v); cover = max(cover, v); }
  if (cover * fade < 0.004) discard;
  gl_FragDepth = clamp(clip.z / clip.w * 0.5 + 0.5, 0.0, 1.0);
  oColour = vec4(colour, cover * fade);
}
`;
