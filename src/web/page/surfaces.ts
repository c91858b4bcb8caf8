// Triangles of curved surfaces: what the objects of the output window are made of.

export type Point = [number, number, number];

/** Eleven numbers for each vertex: position, normal, part, and four coordinates of its own for the shader. */
export interface Mesh {
  vertices: number[];
  indices: number[];
}

/** What a surface is made of, as shader_parts.ts knows it. */
export const part = { lut: 0, matte: 1, gloss: 2, wing: 3, elytron: 4, car: 5, disc: 6, metal: 7 } as const;

export const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const unit = (a: Point): Point => a.map((value) => value / (Math.hypot(...a) || 1)) as Point;
const cross = ([a, b, c]: Point, [x, y, z]: Point): Point => [b * z - c * y, c * x - a * z, a * y - b * x];

/** The surface that `at` draws over [0, 1] x [0, 1]. The shader turns normals to the eye: either side is the front. */
export function addSurface(
  mesh: Mesh,
  [columns, rows]: [number, number],
  kind: number,
  at: (u: number, v: number) => Point,
  own: (u: number, v: number, point: Point) => number[] = (u, v) => [u, v, 0, 0],
): void {
  const first = mesh.vertices.length / 11;
  const step = 1e-3; // far below the size of a triangle, far above rounding
  const inside = (t: number): number => Math.min(Math.max(t, 2 * step), 1 - 2 * step); // poles have no normal
  for (let j = 0; j <= rows; ++j) {
    for (let i = 0; i <= columns; ++i) {
      const [u, v, a, b] = [i / columns, j / rows, inside(i / columns), inside(j / rows)];
      const normal = cross(minus(at(a + step, b), at(a - step, b)), minus(at(a, b + step), at(a, b - step)));
      const point = at(u, v);
      mesh.vertices.push(...point, ...unit(normal), kind, ...own(u, v, point));
      const corner = first + j * (columns + 1) + i;
      const below = corner + columns + 1;
      if (i < columns && j < rows) mesh.indices.push(corner, corner + 1, below, below, corner + 1, below + 1);
    }
  }
}

type Grid = [number, number];
export function addEllipsoid(mesh: Mesh, grid: Grid, kind: number, [x, y, z]: Point, [a, b, c]: Point): void {
  addSurface(mesh, grid, kind, (u, v) => {
    const [around, down] = [2 * Math.PI * u, Math.PI * v];
    const out = Math.sin(down);
    return [x + a * out * Math.cos(around), y + b * Math.cos(down), z + c * out * Math.sin(around)];
  });
}

/** A natural cubic spline through y at rising x: its curvature has no steps, which mirrors would show. */
export function spline(x: number[], y: number[]): (at: number) => number {
  const [bend, ratio] = [x.map(() => 0), x.map(() => 0)];
  for (let i = 1; i < x.length - 1; ++i) {
    const [left, right] = [x[i]! - x[i - 1]!, x[i + 1]! - x[i]!];
    const pivot = 2 * (left + right) - left * ratio[i - 1]!;
    ratio[i] = right / pivot;
    bend[i] = (6 * ((y[i + 1]! - y[i]!) / right - (y[i]! - y[i - 1]!) / left) - left * bend[i - 1]!) / pivot;
  }
  for (let i = x.length - 2; i > 0; --i) bend[i]! -= ratio[i]! * bend[i + 1]!;
  return (at) => {
    let i = 0;
    while (i < x.length - 2 && at > x[i + 1]!) ++i;
    const width = x[i + 1]! - x[i]!;
    const [s, t] = [(x[i + 1]! - at) / width, (at - x[i]!) / width];
    return s * y[i]! + t * y[i + 1]! + (bend[i]! * (s ** 3 - s) + bend[i + 1]! * (t ** 3 - t)) * (width * width) / 6;
  };
}

/** A smooth curve through points, over [0, 1] by their distances. */
export function path(points: Point[]): (t: number) => Point {
  const lengths = [0];
  for (const [i, next] of points.slice(1).entries()) lengths.push(lengths[i]! + Math.hypot(...minus(next, points[i]!)));
  const at = lengths.map((length) => length / lengths.at(-1)!);
  const axes = [0, 1, 2].map((axis) => spline(at, points.map((point) => point[axis]!)));
  return (t) => axes.map((axis) => axis(t)) as Point;
}

/** A round tube along a curve that gets thinner: legs and antennae. */
export function addTube(mesh: Mesh, kind: number, points: Point[], from: number, to: number): void {
  const curve = path(points);
  addSurface(mesh, [18, 8], kind, (u, v) => {
    const side = unit(cross(minus(curve(u + 1e-3), curve(u)), [0.1, 0.2, 1]));
    const up = unit(cross(side, minus(curve(u + 1e-3), curve(u))));
    const radius = (from + (to - from) * u) * Math.min(1, 8 * (1 - u) + 0.05);
    const [c, s] = [radius * Math.cos(2 * Math.PI * v), radius * Math.sin(2 * Math.PI * v)];
    return curve(u).map((value, axis) => value + c * side[axis]! + s * up[axis]!) as Point;
  });
}
