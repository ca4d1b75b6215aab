/**
 * Ambient occlusion in the picture: how much of the sky each place of a surface sees, from the depths around it. After
 * McGuire, Mara and Luebke, "Scalable Ambient Obscurance", High-Performance Graphics 2012.
 */

/** Samples of each pixel, on a spiral. */
const SAMPLES = 14;
const TURNS = 5;

export const OCCLUSION_FRAGMENT = /* glsl */ `
precision highp float;
precision highp int;
uniform sampler2D uDepth;
uniform mat4 uUnproject;
uniform mat4 uProject;
// How far things darken each other, in units of the model.
uniform float uReach;
in vec2 vPlace;
layout(location = 0) out vec4 oColour;

vec3 at(vec2 place) {
  vec4 view = uUnproject * (vec4(place, texture(uDepth, place).r, 1.0) * 2.0 - vec4(1.0, 1.0, 1.0, 1.0));
  return view.xyz / view.w;
}

// Another turn of the spiral in each pixel: patterns become noise, which is blurred away.
float noise(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}

void main() {
  float depth = texture(uDepth, vPlace).r;
  if (depth >= 1.0) {
    oColour = vec4(1.0);
    return;
  }
  vec3 here = at(vPlace);
  vec3 normal = normalize(cross(dFdx(here), dFdy(here)));
  float scale = uProject[3][3] > 0.5 ? uProject[1][1] : uProject[1][1] / max(-here.z, 1e-6);
  float spread = min(uReach * scale * 0.5, 0.25);
  float aspect = uProject[0][0] / uProject[1][1];
  float turn = noise(gl_FragCoord.xy) * 6.2831853;
  float sum = 0.0;
  float reach = uReach * uReach;
  for (int k = 0; k < ${SAMPLES}; k++) {
    float share = (float(k) + 0.5) / float(${SAMPLES});
    float angle = share * ${(TURNS * 2 * Math.PI).toFixed(4)} + turn;
    vec3 away = at(vPlace + spread * share * vec2(cos(angle) * aspect, sin(angle))) - here;
    float square = dot(away, away);
    float near = max(reach - square, 0.0) / reach;
    sum += near * near * near * max(dot(away, normal) - 0.012 * uReach, 0.0) / (sqrt(square) + 1e-4 * uReach);
  }
  // Where a surface turns away from the eye its depths say little of its direction.
  float facing = uProject[3][3] > 0.5 ? normal.z : dot(normal, normalize(-here));
  sum *= smoothstep(0.08, 0.4, facing);
  oColour = vec4(vec3(clamp(1.0 - 2.1 * sum / float(${SAMPLES}), 0.0, 1.0)), 1.0);
}
`;

/** Lays it over the picture, blurred among places of about the same depth. */
export const DARKEN_FRAGMENT = /* glsl */ `
precision highp float;
uniform sampler2D uPicture;
uniform sampler2D uDepth;
uniform vec2 uStep;
in vec2 vPlace;
layout(location = 0) out vec4 oColour;

void main() {
  float depth = texture(uDepth, vPlace).r;
  float sum = 0.0;
  float all = 0.0;
  for (int x = -2; x <= 2; x++) {
    for (int y = -2; y <= 2; y++) {
      vec2 place = vPlace + uStep * vec2(float(x), float(y));
      float weight = 1.0 / (1.0 + 4000.0 * abs(texture(uDepth, place).r - depth) / max(1.0 - depth, 1e-4));
      sum += texture(uPicture, place).r * weight;
      all += weight;
    }
  }
  oColour = vec4(vec3(sum / all), 1.0);
}
`;

/** A sky: paler towards the horizon, and the ground below it. */
export const SKY_FRAGMENT = /* glsl */ `
precision highp float;
uniform mat4 uUnproject;
uniform mat4 uToWorld;
uniform vec3 uHigh;
uniform vec3 uHorizon;
uniform vec3 uLow;
in vec2 vPlace;
layout(location = 0) out vec4 oColour;

void main() {
  vec4 far = uUnproject * vec4(vPlace * 2.0 - 1.0, 1.0, 1.0);
  vec4 near = uUnproject * vec4(vPlace * 2.0 - 1.0, -1.0, 1.0);
  vec3 way = mat3(uToWorld) * normalize(far.xyz / far.w - near.xyz / near.w);
  float up = way.z;
  vec3 sky = mix(uHorizon, uHigh, smoothstep(0.0, 0.7, up));
  vec3 ground = mix(uHorizon, uLow, smoothstep(0.0, 0.6, -up));
  oColour = vec4(up > 0.0 ? sky : ground, 1.0);
}
`;
