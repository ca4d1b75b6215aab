/** What all shaders share: the table of colours, and lengths in pixels. */

/** How wide the table of colours is; its height grows. */
export const TABLE_WIDTH = 256;

export const COMMON_VERTEX = /* glsl */ `
precision highp float;
precision highp int;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform sampler2D uTable;
uniform vec4 uLook;
uniform bool uIsBatch;
uniform int uPass;
uniform float uNear;
in float slot;
out vec4 vLook;

// The colour: one for all that is drawn, or that of each position's place in the table.
vec4 look() {
  if (!uIsBatch) return uLook;
  int at = int(slot + 0.5);
  return texelFetch(uTable, ivec2(at % ${TABLE_WIDTH}, at / ${TABLE_WIDTH}), 0);
}

// Whether this look is drawn now: pass 0 draws what hides, pass 1 what shines through, pass 2 both.
bool drawn(vec4 colour) {
  if (colour.a < 0.002) return false;
  if (uPass == 0) return colour.a > 0.998;
  if (uPass == 1) return colour.a <= 0.998;
  return true;
}

// How far a place in the coordinates of the eye is beyond the plane that cuts the view.
uniform vec4 uSection;

float beyond(vec3 view) {
  return dot(uSection.xyz, view) + uSection.w;
}

const vec4 NOWHERE = vec4(2.0, 2.0, 2.0, 1.0);

// A little nearer to the eye, so that what lies on a surface is not swallowed by its triangles.
vec4 nearer(vec4 view) {
  bool perspective = projectionMatrix[3][3] < 0.5;
  return perspective ? vec4(view.xyz * (1.0 - uNear), 1.0) : vec4(view.xy, view.z + uNear / projectionMatrix[1][1], 1.0);
}
`;
