/** Surfaces: shaded, rendered, drawn as on paper, in false colours, with zebra stripes. */

import { COMMON_VERTEX } from "./common";

/** The numbers of `uShade`. */
export const SHADE = { shaded: 0, rendered: 1, technical: 2, falseColour: 3, zebra: 4 } as const;

/** How light falls on a surface, in the coordinates of the eye. */
const LIGHTS = /* glsl */ `
vec3 toEye(vec3 view) {
  return projectionMatrix[3][3] > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(-view);
}

vec3 turned(vec3 normal, vec3 eye) {
  return dot(normal, eye) < 0.0 ? -normal : normal;
}

// Light from above the left shoulder, a weaker one from the right below, and some from everywhere.
float headlight(vec3 normal) {
  float key = max(dot(normal, normalize(vec3(-0.35, 0.55, 0.75))), 0.0);
  float fill = max(dot(normal, normalize(vec3(0.7, -0.25, 0.45))), 0.0);
  return 0.36 + 0.58 * key + 0.16 * fill;
}

// Darkens towards black and, beyond full light, brightens towards white.
vec3 lit(vec3 colour, float light) {
  return light <= 1.0 ? colour * light : mix(colour, vec3(1.0), min(light - 1.0, 1.0));
}

float gloss(vec3 normal, vec3 eye, float sharpness) {
  vec3 half_ = normalize(normalize(vec3(-0.3, 0.6, 0.75)) + eye);
  return pow(max(dot(normal, half_), 0.0), sharpness);
}

// A studio made of numbers: a bright sky, a dim floor, one great soft lamp above and one at the side.
vec3 studio(vec3 direction, float blur) {
  float sky = smoothstep(-0.25 - blur, 0.55 + blur, direction.z);
  vec3 light = mix(vec3(0.30, 0.29, 0.28), vec3(0.86, 0.89, 0.94), sky);
  float lamp = dot(direction, normalize(vec3(-0.45, -0.55, 0.80)));
  light += vec3(1.10, 1.05, 0.98) * smoothstep(0.93 - blur * 1.1, 0.99 + blur * 0.2, lamp);
  float side = dot(direction, normalize(vec3(0.85, -0.25, 0.25)));
  return light + vec3(0.30, 0.36, 0.45) * smoothstep(0.90 - blur, 0.99, side);
}

vec3 rendered(vec3 colour, vec3 normal, vec3 eye) {
  mat3 toWorld = transpose(mat3(viewMatrix));
  vec3 up = toWorld * normal;
  vec3 away = toWorld * reflect(-eye, normal);
  vec3 base = pow(colour, vec3(2.2));
  vec3 around = mix(vec3(0.20, 0.19, 0.18), vec3(0.50, 0.53, 0.58), up.z * 0.5 + 0.5);
  float lamp = max(dot(up, normalize(vec3(-0.45, -0.55, 0.80))), 0.0);
  float edge = pow(1.0 - max(dot(normal, eye), 0.0), 5.0);
  vec3 light = base * (around + vec3(0.46, 0.45, 0.43) * lamp) + studio(away, 0.12) * (0.03 + 0.25 * edge);
  return pow(light, vec3(1.0 / 2.2));
}

vec3 shaded(vec3 colour, vec3 normal, vec3 eye) {
  return lit(colour, headlight(normal) + 0.22 * gloss(normal, eye, 28.0));
}
`;

export const MESH_VERTEX = /* glsl */ `
${COMMON_VERTEX}
uniform mat3 normalMatrix;
uniform int uHas;
in vec3 position;
in vec3 normal;
in vec4 colour;
in float value;
out vec3 vView;
out vec3 vNormal;
out float vValue;
out float vBeyond;

void main() {
  vLook = look();
  if (!drawn(vLook)) {
    gl_Position = NOWHERE;
    return;
  }
  if ((uHas & 2) != 0) vLook = vec4(colour.rgb, vLook.a * colour.a);
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  vView = view.xyz;
  vBeyond = beyond(view.xyz);
  vNormal = (uHas & 1) != 0 ? normalMatrix * normal : vec3(0.0);
  vValue = value;
  gl_Position = projectionMatrix * view;
}
`;

export const MESH_FRAGMENT = /* glsl */ `
precision highp float;
precision highp int;
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
uniform int uShade;
uniform int uHas;
uniform float uAlpha;
uniform vec2 uRange;
uniform sampler2D uRamp;
uniform float uStripes;
uniform int uStripesAcross;
uniform vec3 uPaper;
uniform vec3 uInk;
in vec4 vLook;
in vec3 vView;
in vec3 vNormal;
in float vValue;
in float vBeyond;
layout(location = 0) out vec4 oColour;

${LIGHTS}

// Without normals of its own a triangle is flat.
vec3 across() {
  return dot(vNormal, vNormal) > 0.01 ? normalize(vNormal) : normalize(cross(dFdx(vView), dFdy(vView)));
}

// A contour where a surface turns away from the eye, about as wide as a line.
float contour(vec3 eye) {
  if (dot(vNormal, vNormal) < 0.01) return 0.0;
  float turn = abs(dot(normalize(vNormal), eye));
  float pixels = turn / max(fwidth(turn), 1e-6);
  return 1.0 - smoothstep(0.9, 1.9, pixels);
}

void main() {
  if (vBeyond > 0.0) discard;
  vec3 eye = toEye(vView);
  vec3 normal = turned(across(), eye);
  vec4 colour = vec4(vLook.rgb, vLook.a * uAlpha);
  if (uShade == ${SHADE.rendered}) {
    colour.rgb = rendered(colour.rgb, normal, eye);
  } else if (uShade == ${SHADE.technical}) {
    colour = vec4(mix(uPaper * (0.90 + 0.10 * headlight(normal)), uInk, contour(eye)), 1.0);
  } else if (uShade == ${SHADE.falseColour} && (uHas & 4) != 0) {
    float place = clamp((vValue - uRange.x) / max(uRange.y - uRange.x, 1e-30), 0.0, 1.0);
    colour = vec4(lit(texture(uRamp, vec2(place * 0.99609375 + 0.001953125, 0.5)).rgb, 0.45 + 0.55 * headlight(normal)), 1.0);
  } else if (uShade == ${SHADE.zebra}) {
    vec3 away = reflect(-eye, normal);
    float angle = asin(clamp(uStripesAcross == 1 ? away.x : away.y, -1.0, 1.0)) * 2.0;
    float wave = angle * uStripes * 0.31830989;
    float soft = max(fwidth(wave), 1e-4);
    float stripe = clamp((abs(fract(wave) - 0.5) - 0.25) / soft + 0.5, 0.0, 1.0);
    colour = vec4(mix(vec3(0.08), vec3(0.97), stripe) * (0.75 + 0.25 * headlight(normal)), 1.0);
  } else {
    colour.rgb = shaded(colour.rgb, normal, eye);
  }
#ifdef HIDES
  colour.a = 1.0;
#endif
  oColour = colour;
}
`;

/**
 * Surfaces in quick pictures, shaded or rendered: light is found at the vertices, where they have normals. Software takes as
 * long as the lights of all pixels take.
 */
export const QUICK_VERTEX = /* glsl */ `
${COMMON_VERTEX}
uniform mat3 normalMatrix;
uniform mat4 viewMatrix;
uniform int uHas;
uniform int uShade;
uniform float uAlpha;
in vec3 position;
in vec3 normal;
in vec4 colour;
out vec3 vView;
out float vBeyond;

${LIGHTS}

void main() {
  vLook = look();
  if (!drawn(vLook)) {
    gl_Position = NOWHERE;
    return;
  }
  if ((uHas & 2) != 0) vLook = vec4(colour.rgb, vLook.a * colour.a);
  vLook.a *= uAlpha;
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  vView = view.xyz;
  vBeyond = beyond(view.xyz);
  if ((uHas & 1) != 0) {
    vec3 eye = toEye(view.xyz);
    vec3 up = turned(normalize(normalMatrix * normal), eye);
    vLook.rgb = uShade == ${SHADE.rendered} ? rendered(vLook.rgb, up, eye) : shaded(vLook.rgb, up, eye);
  }
  gl_Position = projectionMatrix * view;
}
`;

export const QUICK_FRAGMENT = /* glsl */ `
precision highp float;
precision highp int;
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
uniform int uHas;
uniform int uShade;
in vec4 vLook;
in vec3 vView;
in float vBeyond;
layout(location = 0) out vec4 oColour;

${LIGHTS}

void main() {
  if (vBeyond > 0.0) discard;
  oColour = vLook;
  if ((uHas & 1) == 0) {
    vec3 eye = toEye(vView);
    vec3 normal = turned(normalize(cross(dFdx(vView), dFdy(vView))), eye);
    oColour.rgb = uShade == ${SHADE.rendered} ? rendered(oColour.rgb, normal, eye) : shaded(oColour.rgb, normal, eye);
  }
#ifdef HIDES
  oColour.a = 1.0;
#endif
}
`;
