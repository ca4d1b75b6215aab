/** Models for tests and for eyes: closed forms, with edges and isocurves as the kernel sends them. */

import { sphere, surface, torus, type Grid } from "../unit/shapes";
import type { TestPart, TestPreview } from "../unit/previewBytes";

type Triple = [number, number, number];

/** Lines of a grid: every so many columns and rows, as segments. */
function isocurves(grid: Grid, columns: number, rows: number, every: number): number[] {
  const at = (row: number, column: number): number[] => {
    const vertex = (row * (columns + 1) + column) * 3;
    return [...grid.positions.slice(vertex, vertex + 3)];
  };
  const lines: number[] = [];
  for (let row = every; row < rows; row += every) {
    for (let column = 0; column < columns; column++) lines.push(...at(row, column), ...at(row, column + 1));
  }
  for (let column = every; column < columns; column += every) {
    for (let row = 0; row < rows; row++) lines.push(...at(row, column), ...at(row + 1, column));
  }
  return lines;
}

function borders(grid: Grid, columns: number, rows: number): number[] {
  const at = (row: number, column: number) => [...grid.positions.slice((row * (columns + 1) + column) * 3, (row * (columns + 1) + column) * 3 + 3)];
  const lines: number[] = [];
  for (const row of [0, rows]) for (let column = 0; column < columns; column++) lines.push(...at(row, column), ...at(row, column + 1));
  for (const column of [0, columns]) for (let row = 0; row < rows; row++) lines.push(...at(row, column), ...at(row + 1, column));
  return lines;
}

function moved(parts: TestPart[], [x, y, z]: Triple): TestPart[] {
  return parts.map((part) => ({ ...part, positions: Float32Array.from(part.positions, (value, at) => value + [x, y, z][at % 3]!) }));
}

function surfaceParts(grid: Grid, columns: number, rows: number, every: number): TestPart[] {
  return [
    { kind: "mesh", ...grid, pieces: [{ output: 0, path: "{0}", index: 0, start: 0, count: grid.indices.length }] },
    { kind: "edges", positions: borders(grid, columns, rows) },
    { kind: "isocurves", positions: isocurves(grid, columns, rows, every) },
  ];
}

export function box(size: Triple, at: Triple = [0, 0, 0], index = 0): TestPart[] {
  const [a, b, c] = size;
  const corners: Triple[] = [[0, 0, 0], [a, 0, 0], [a, b, 0], [0, b, 0], [0, 0, c], [a, 0, c], [a, b, c], [0, b, c]];
  const faces: [number[], Triple][] = [
    [[0, 3, 2, 1], [0, 0, -1]], [[4, 5, 6, 7], [0, 0, 1]], [[0, 1, 5, 4], [0, -1, 0]],
    [[2, 3, 7, 6], [0, 1, 0]], [[1, 2, 6, 5], [1, 0, 0]], [[3, 0, 4, 7], [-1, 0, 0]],
  ];
  const positions = faces.flatMap(([face]) => face.flatMap((corner) => corners[corner]!));
  const normals = faces.flatMap(([, normal]) => [normal, normal, normal, normal].flat());
  const indices = faces.flatMap((_, face) => [0, 1, 2, 0, 2, 3].map((corner) => face * 4 + corner));
  const edges = [0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 5, 6, 6, 7, 7, 4, 0, 4, 1, 5, 2, 6, 3, 7].flatMap((corner) => corners[corner]!);
  return moved([
    { kind: "mesh", positions, normals, indices, pieces: [{ output: 0, path: "{0}", index, start: 0, count: 36 }] },
    { kind: "edges", positions: edges },
  ], at);
}

function wave(columns: number, rows: number): Grid {
  return surface(columns, rows, (u, v) => {
    const [x, y] = [u * 20 - 10, v * 14 - 7];
    const z = 2.2 * Math.sin(x * 0.45) * Math.cos(y * 0.4) + 3;
    const [dx, dy] = [2.2 * 0.45 * Math.cos(x * 0.45) * Math.cos(y * 0.4), -2.2 * 0.4 * Math.sin(x * 0.45) * Math.sin(y * 0.4)];
    const length = Math.hypot(dx, dy, 1);
    return { point: [x, y, z], normal: [-dx / length, -dy / length, 1 / length] };
  });
}

function helix(count: number): number[] {
  const at = (step: number): Triple => {
    const angle = (step / count) * 6 * Math.PI;
    return [12 + 2.5 * Math.cos(angle), 9 + 2.5 * Math.sin(angle), angle * 0.35];
  };
  return Array.from({ length: count }, (_, step) => [...at(step), ...at(step + 1)]).flat();
}

/** Something of everything. */
function everything(): TestPreview[] {
  const bowl = torus(3.4, 1.3, 96, 48);
  const ball = sphere(2.2, 64, 32);
  return [
    { object: "wave", parts: surfaceParts(wave(80, 60), 80, 60, 10) },
    { object: "torus", parts: moved(surfaceParts(bowl, 96, 48, 8), [-4, -13, 1.3]) },
    { object: "ball", parts: moved([{ kind: "mesh", ...ball, colour: [64, 120, 190, 255] }], [6, -13, 2.2]) },
    { object: "box", parts: box([4, 3, 5], [12, -8, 0]) },
    { object: "helix", parts: [{ kind: "curves", positions: helix(240) }] },
    { object: "points", parts: [{ kind: "points", positions: [-10, -7, 3, 10, -7, 3, 10, 7, 3, -10, 7, 3, 0, 0, 6] }] },
    { object: "net", parts: [{ kind: "controlPoints", positions: [-12, 9, 0, -9, 11, 3, -6, 8, 0, -3, 11, 2] }, { kind: "curves", width: 1, positions: [-12, 9, 0, -9, 11, 3, -9, 11, 3, -6, 8, 0, -6, 8, 0, -3, 11, 2] }] },
    { object: "arrows", parts: [{ kind: "arrows", positions: [0, 0, 3, 0, 0, 8, -10, -7, 3, -12, -9, 5, 0, 0, 3, 4, 0, 3] }] },
    { object: "tags", parts: [{ kind: "texts", positions: [12, -8, 5.2, -4, -13, 4], texts: ["B4", "Torus R 3.4"] }, { kind: "texts", positions: [0, -17, 0], texts: ["plan 1:100"], textHeight: 1.2 }] },
  ];
}

export const scenes: Record<string, () => TestPreview[]> = {
  everything,
  torus: () => [{ object: "torus", parts: surfaceParts(torus(10, 3, 96, 48), 96, 48, 8) }],
  box: () => [{ object: "box", parts: box([10, 10, 10], [-5, -5, -5]) }],
  boxes: () => Array.from({ length: 400 }, (_, at) => ({ object: `box ${at}`, parts: box([0.6, 0.6, 0.4 + (at % 7) * 0.3], [at % 20, Math.floor(at / 20), 0]) })),
  far: () => [{ object: "box", origin: [5e6, 4e6, 300], parts: box([10, 10, 10]) }],
};
