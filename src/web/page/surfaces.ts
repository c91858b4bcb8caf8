// Triangles of curved surfaces: what the objects of the output window are made of.

export type Point = [number, number, number];
export type Local = [number, number, number, number];

/** Eleven numbers for each vertex: position, normal, part, and four coordinates of its own that shaders.ts draws with. */
export interface Mesh {
  vertices: number[];
  indices: number[];
}

/** What a surface is made of, as shaders.ts knows it. */
export const part = { lut: 0, matte: 1, gloss: 2, wing: 3, elytron: 4, car: 5, disc: 6, metal: 7 } as const;

export const emptyMesh = (): Mesh => ({ vertices: [], indices: [] });

const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const unit = (a: Point): Point => {
  const length = Math.hypot(...a) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
};

/** The surface that `at` draws over [0, 1] x [0, 1]. The shader turns normals to the eye, so either side is the front.
 *  @param local  the four coordinates; where there are none, (u, v, 0, 0) */
export function addSurface(
  mesh: Mesh,
  [columns, rows]: [number, number],
  kind: number,
  at: (u: number, v: number) => Point,
  local: (u: number, v: number, point: Point) => Local = (u, v) => [u, v, 0, 0],
): void {
  const first = mesh.vertices.length / 11;
  const step = 1e-3; // far below the size of a triangle, far above rounding
  const inside = (t: number): number => Math.min(Math.max(t, 2 * step), 1 - 2 * step);
  for (let j = 0; j <= rows; ++j) {
    for (let i = 0; i <= columns; ++i) {
      const [u, v] = [i / columns, j / rows];
      const [a, b] = [inside(u), inside(v)]; // poles have no normal of their own
      const along = minus(at(a + step, b), at(a - step, b));
      const across = minus(at(a, b + step), at(a, b - step));
      const point = at(u, v);
      mesh.vertices.push(...point, ...unit(cross(along, across)), kind, ...local(u, v, point));
      if (i === columns || j === rows) continue;
      const corner = first + j * (columns + 1) + i;
      const below = corner + columns + 1;
      mesh.indices.push(corner, corner + 1, below, below, corner + 1, below + 1);
    }
  }
}

export function addEllipsoid(mesh: Mesh, grid: [number, number], kind: number, middle: Point, radii: Point): void {
  addSurface(mesh, grid, kind, (u, v) => {
    const [around, down] = [2 * Math.PI * u, Math.PI * v];
    return [
      middle[0] + radii[0] * Math.sin(down) * Math.cos(around),
      middle[1] + radii[1] * Math.cos(down),
      middle[2] + radii[2] * Math.sin(down) * Math.sin(around),
    ];
  });
}

/** A smooth curve (natural cubic spline) through y at rising x: its curvature has no steps, which mirrors would show. */
export function spline(x: number[], y: number[]): (at: number) => number {
  const n = x.length;
  const bend = new Array<number>(n).fill(0);
  const ratio = new Array<number>(n).fill(0);
  for (let i = 1; i < n - 1; ++i) {
    const [left, right] = [x[i]! - x[i - 1]!, x[i + 1]! - x[i]!];
    const slopes = (y[i + 1]! - y[i]!) / right - (y[i]! - y[i - 1]!) / left;
    const pivot = 2 * (left + right) - left * ratio[i - 1]!;
    ratio[i] = right / pivot;
    bend[i] = (6 * slopes - left * bend[i - 1]!) / pivot;
  }
  for (let i = n - 2; i > 0; --i) bend[i] = bend[i]! - ratio[i]! * bend[i + 1]!;
  return (at) => {
    let i = 0;
    while (i < n - 2 && at > x[i + 1]!) ++i;
    const width = x[i + 1]! - x[i]!;
    const t = (at - x[i]!) / width;
    const curved = (bend[i]! * ((1 - t) ** 3 - (1 - t)) + bend[i + 1]! * (t ** 3 - t)) * (width * width) / 6;
    return (1 - t) * y[i]! + t * y[i + 1]! + curved;
  };
}

/** A smooth curve through points, over [0, 1] by their distances. */
export function path(points: number[][]): (t: number) => number[] {
  const lengths = [0];
  for (let i = 1; i < points.length; ++i) {
    lengths.push(lengths[i - 1]! + Math.hypot(...points[i]!.map((value, axis) => value - points[i - 1]![axis]!)));
  }
  const whole = lengths.at(-1)!;
  const axes = points[0]!.map((_, axis) => spline(lengths.map((l) => l / whole), points.map((point) => point[axis]!)));
  return (t) => axes.map((axis) => axis(t));
}

/** A round tube along a curve that gets thinner: legs and antennae. */
export function addTube(mesh: Mesh, kind: number, points: Point[], from: number, to: number): void {
  const curve = path(points);
  addSurface(mesh, [24, 10], kind, (u, v) => {
    const [here, ahead] = [curve(u) as Point, curve(u + 1e-3) as Point];
    const along = unit(minus(ahead, here));
    const side = unit(cross(along, [0.1, 0.2, 1]));
    const up = cross(side, along);
    const radius = (from + (to - from) * u) * Math.min(1, 8 * (1 - u) + 0.05);
    const [c, s] = [radius * Math.cos(2 * Math.PI * v), radius * Math.sin(2 * Math.PI * v)];
    return [here[0] + c * side[0] + s * up[0], here[1] + c * side[1] + s * up[1], here[2] + c * side[2] + s * up[2]];
  });
}
