/** What draws: a graphics card, or software that stands in for one. */

/** What is drawn by software takes as long as it has pixels and lines. */
const SOFTWARE = /swiftshader|llvmpipe|software|basic render/i;

/** Whether pictures are made by software. Throws where there is no WebGL 2. */
export function isSoftware(): boolean {
  known ??= look();
  return known;
}

let known: boolean | undefined;

function look(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) throw new Error("no WebGL 2");
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return SOFTWARE.test(name);
}
