// A viewer of one binary glTF file: drag turns, the wheel zooms, shift and drag moves.
(function () {
  const bytes = Uint8Array.from(atob(MODEL), (c) => c.charCodeAt(0));
  const words = new DataView(bytes.buffer);
  const jsonLength = words.getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + jsonLength)));
  const start = 20 + jsonLength + 8;
  const canvas = document.querySelector("canvas");
  const gl = canvas.getContext("webgl", { antialias: true, preserveDrawingBuffer: true });
  if (!gl || !gl.getExtension("OES_element_index_uint") || !gl.getExtension("OES_standard_derivatives")) return;

  const sizes = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
  const kinds = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };
  function numbers(index) {
    const accessor = gltf.accessors[index];
    const view = gltf.bufferViews[accessor.bufferView];
    const Kind = kinds[accessor.componentType];
    const width = sizes[accessor.type];
    const at = start + (view.byteOffset || 0) + (accessor.byteOffset || 0);
    const stride = view.byteStride || width * Kind.BYTES_PER_ELEMENT;
    const out = new Kind(accessor.count * width);
    for (let i = 0; i < accessor.count; i++) {
      const row = bytes.slice(at + i * stride, at + i * stride + width * Kind.BYTES_PER_ELEMENT);
      out.set(new Kind(row.buffer), i * width);
    }
    return out;
  }

  const multiply = (a, b) => {
    const m = new Float32Array(16);
    for (let c = 0; c < 4; c++)
      for (let r = 0; r < 4; r++) for (let k = 0; k < 4; k++) m[4 * c + r] += a[4 * k + r] * b[4 * c + k];
    return m;
  };
  const identity = () => new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
  function local(node) {
    if (node.matrix) return new Float32Array(node.matrix);
    const [x, y, z, w] = node.rotation || [0, 0, 0, 1];
    const s = node.scale || [1, 1, 1];
    const t = node.translation || [0, 0, 0];
    return new Float32Array([
      s[0] * (1 - 2 * (y * y + z * z)), s[0] * 2 * (x * y + z * w), s[0] * 2 * (x * z - y * w), 0,
      s[1] * 2 * (x * y - z * w), s[1] * (1 - 2 * (x * x + z * z)), s[1] * 2 * (y * z + x * w), 0,
      s[2] * 2 * (x * z + y * w), s[2] * 2 * (y * z - x * w), s[2] * (1 - 2 * (x * x + y * y)), 0,
      t[0], t[1], t[2], 1,
    ]);
  }

  const parts = [];
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  function visit(index, above) {
    const node = gltf.nodes[index];
    const matrix = multiply(above, local(node));
    for (const primitive of node.mesh === undefined ? [] : gltf.meshes[node.mesh].primitives) {
      const positions = numbers(primitive.attributes.POSITION);
      for (let i = 0; i < positions.length; i += 3) {
        const [x, y, z] = positions.subarray(i, i + 3);
        for (let k = 0; k < 3; k++) {
          const v = matrix[k] * x + matrix[4 + k] * y + matrix[8 + k] * z + matrix[12 + k];
          low[k] = Math.min(low[k], v);
          high[k] = Math.max(high[k], v);
        }
      }
      const mode = primitive.mode === undefined ? 4 : primitive.mode;
      const material = (gltf.materials || [])[primitive.material] || {};
      const usual = mode >= 4 ? [0.75, 0.78, 0.8, 1] : [0.1, 0.1, 0.1, 1];
      const color = (material.pbrMetallicRoughness || {}).baseColorFactor || usual;
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, positions, gl.STATIC_DRAW);
      let indices = null;
      let count = positions.length / 3;
      if (primitive.indices !== undefined) {
        const list = Uint32Array.from(numbers(primitive.indices));
        indices = gl.createBuffer();
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, list, gl.STATIC_DRAW);
        count = list.length;
      }
      parts.push({ matrix, mode, color, buffer, indices, count });
    }
    for (const child of node.children || []) visit(child, matrix);
  }
  for (const root of gltf.scenes[gltf.scene || 0].nodes || []) visit(root, identity());
  if (!parts.length) return;

  function shader(kind, text) {
    const made = gl.createShader(kind);
    gl.shaderSource(made, text);
    gl.compileShader(made);
    return made;
  }
  const program = gl.createProgram();
  gl.attachShader(program, shader(gl.VERTEX_SHADER,
    "attribute vec3 p; uniform mat4 model, view, lens; varying vec3 at;" +
    "void main() { vec4 v = view * model * vec4(p, 1.0); at = v.xyz; gl_Position = lens * v; gl_PointSize = 5.0; }"));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER,
    "#extension GL_OES_standard_derivatives : enable\n" +
    "precision highp float; varying vec3 at; uniform vec4 color; uniform bool lit;" +
    "void main() { float light = 1.0; if (lit) { vec3 n = normalize(cross(dFdx(at), dFdy(at)));" +
    "light = 0.35 + 0.65 * abs(dot(n, normalize(vec3(0.3, 0.5, 1.0)))); } gl_FragColor = vec4(color.rgb * light, color.a); }"));
  gl.linkProgram(program);
  gl.useProgram(program);
  const place = (name) => gl.getUniformLocation(program, name);

  const middle = low.map((x, k) => (x + high[k]) / 2);
  const size = Math.hypot(...low.map((x, k) => high[k] - x)) || 1;
  const eye = { turn: -0.6, tilt: 0.5, far: 1.3 * size, move: [0, 0] };
  function draw() {
    const ratio = window.devicePixelRatio || 1;
    canvas.width = canvas.clientWidth * ratio;
    canvas.height = canvas.clientHeight * ratio;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(1, 1, 1, 1);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const [st, ct, sp, cp] = [Math.sin(eye.turn), Math.cos(eye.turn), Math.sin(eye.tilt), Math.cos(eye.tilt)];
    const spin = new Float32Array([ct, st * sp, -st * cp, 0, 0, cp, sp, 0, st, -ct * sp, ct * cp, 0, 0, 0, 0, 1]);
    const center = identity();
    const back = identity();
    for (let k = 0; k < 3; k++) center[12 + k] = -middle[k];
    [back[12], back[13], back[14]] = [eye.move[0], eye.move[1], -eye.far];
    const [near, far] = [eye.far / 100, eye.far + 4 * size];
    const f = 1.8;
    const lens = new Float32Array([(f * canvas.height) / canvas.width, 0, 0, 0, 0, f, 0, 0, 0, 0,
      (far + near) / (near - far), -1, 0, 0, (2 * far * near) / (near - far), 0]);
    gl.uniformMatrix4fv(place("view"), false, multiply(back, multiply(spin, center)));
    gl.uniformMatrix4fv(place("lens"), false, lens);
    for (const part of parts) {
      gl.uniformMatrix4fv(place("model"), false, part.matrix);
      gl.uniform4fv(place("color"), part.color);
      gl.uniform1i(place("lit"), part.mode >= 4);
      gl.bindBuffer(gl.ARRAY_BUFFER, part.buffer);
      gl.enableVertexAttribArray(0);
      gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
      if (part.indices) {
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, part.indices);
        gl.drawElements(part.mode, part.count, gl.UNSIGNED_INT, 0);
      } else gl.drawArrays(part.mode, 0, part.count);
    }
  }
  canvas.onpointermove = (event) => {
    if (!event.buttons) return;
    if (event.shiftKey) {
      eye.move[0] += (event.movementX * eye.far) / canvas.clientHeight;
      eye.move[1] -= (event.movementY * eye.far) / canvas.clientHeight;
    } else {
      eye.turn -= event.movementX / 150;
      eye.tilt = Math.max(-1.57, Math.min(1.57, eye.tilt + event.movementY / 150));
    }
    draw();
  };
  canvas.onpointerdown = (event) => canvas.setPointerCapture(event.pointerId);
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    eye.far *= Math.exp(event.deltaY / 600);
    draw();
  }, { passive: false });
  window.onresize = draw;
  draw();
})();
