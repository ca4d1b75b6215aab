/** Meshes with exact normals for tests: positions and normals come from closed forms. */

export interface Grid {
  positions: Float32Array;
  normals: Float32Array;
  indices: Uint32Array;
}

type Triple = [number, number, number];

/** A surface (u, v from 0 to 1) with its unit normal, as a grid of triangles wound to the side of the normal. */
export function surface(columns: number, rows: number, at: (u: number, v: number) => { point: Triple; normal: Triple }): Grid {
  const positions = new Float32Array((columns + 1) * (rows + 1) * 3);
  const normals = new Float32Array(positions.length);
  const indices = new Uint32Array(columns * rows * 6);
  for (let row = 0; row <= rows; row++) {
    for (let column = 0; column <= columns; column++) {
      const { point, normal } = at(column / columns, row / rows);
      const vertex = row * (columns + 1) + column;
      positions.set(point, vertex * 3);
      normals.set(normal, vertex * 3);
      if (row === rows || column === columns) continue;
      const above = vertex + columns + 1;
      indices.set([vertex, vertex + 1, above + 1, vertex, above + 1, above], (row * columns + column) * 6);
    }
  }
  return { positions, normals, indices };
}

/** A torus about z: `u` goes round the axis. */
export function torus(major: number, minor: number, columns: number, rows: number): Grid {
  return surface(columns, rows, (u, v) => {
    const [a, b] = [u * 2 * Math.PI, v * 2 * Math.PI];
    const out = major + minor * Math.cos(b);
    return {
      point: [out * Math.cos(a), out * Math.sin(a), minor * Math.sin(b)],
      normal: [Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)],
    };
  });
}

export function sphere(radius: number, columns: number, rows: number): Grid {
  return surface(columns, rows, (u, v) => {
    const [a, b] = [u * 2 * Math.PI, (v - 0.5) * Math.PI * 0.98];
    const normal: Triple = [Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)];
    return { point: [radius * normal[0], radius * normal[1], radius * normal[2]], normal };
  });
}
