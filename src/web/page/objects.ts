// The objects that the output window shows, made by code. All shapes are drawn by eye.

import { addEllipsoid, addSurface, addTube, type Mesh, part, path, type Point, spline } from "./surfaces";

export type ObjectName = "sphere" | "wing" | "elytra" | "car" | "bubble" | "disc";

export interface ShownObject {
  mesh: Mesh;
  /** First turn around the vertical and height of the camera, in degrees. */
  turn: number;
  pitch: number;
  /** Half of the width and the height that must be in the picture. */
  reach: [number, number];
  /** Height of the floor, and half the length and width of the object's shade on it. */
  floor: number;
  shade: [number, number];
}

const mirrored = (points: Point[], side: number): Point[] => points.map(([x, y, z]) => [x, y, side * z]);
const ring = (radius: number, turn: number): [number, number] =>
  [radius * Math.cos(2 * Math.PI * turn), radius * Math.sin(2 * Math.PI * turn)];

function addDisc(mesh: Mesh): void {
  const hole = 0.125; // of a radius of 60 mm
  const flat = (radius: number, y: number, u: number): Point => [ring(radius, u)[0], y, ring(radius, u)[1]];
  const radiusAt = (v: number): number => hole + (1 - hole) * v;
  addSurface(mesh, [160, 4], part.disc, (u, v) => flat(radiusAt(v), 0, u), (_u, v) => [radiusAt(v), 0, 0, 0]);
  for (const radius of [hole, 1]) addSurface(mesh, [160, 1], part.gloss, (u, v) => flat(radius, -0.018 * v, u));
}

/** One wing case: from the shoulder to the tail, and from the seam down to the side. */
const caseWidth = spline([0, 0.12, 0.45, 0.75, 1], [0.5, 0.565, 0.63, 0.6, 0.52]);
const caseHeight = spline([0, 0.3, 0.6, 1], [0.4, 0.5, 0.49, 0.4]);
function wingCase(u: number, v: number): Point {
  const closing = (1 - Math.max(0, (u - 0.3) / 0.7) ** 2.3) ** (1 / 2.3);
  const shoulder = 1 - 0.25 * Math.max(0, 1 - u / 0.07) ** 2;
  const angle = 0.58 * Math.PI * v;
  const y = caseHeight(u) * closing * shoulder * Math.cos(angle) - 0.02 * Math.exp(-((v / 0.035) ** 2));
  return [0.45 - 1.5 * u, y, caseWidth(u) * closing * Math.sin(angle) ** 0.94 + 0.002];
}

function addBeetle(mesh: Mesh): void {
  for (const side of [-1, 1]) {
    addSurface(mesh, [64, 40], part.elytron, (u, v) => mirrored([wingCase(u, v)], side)[0]!);
    const antenna: Point[] = [[1.03, 0.06, 0.07], [1.2, 0.2, 0.2], [1.32, 0.22, 0.42], [1.36, 0.16, 0.62]];
    addTube(mesh, part.gloss, mirrored(antenna, side), 0.02, 0.012);
    addEllipsoid(mesh, [20, 14], part.gloss, [0.98, 0.06, 0.17 * side], [0.07, 0.075, 0.06]);
    for (const [x, knee, foot] of [[0.55, 0.8, 1.02], [0.15, 0.18, 0.22], [-0.25, -0.62, -1.0]] as const) {
      const leg: Point[] = [[x, -0.16, 0.3], [(x + knee) / 2, -0.02, 0.62], [knee, 0.02, 0.8],
        [(knee + foot) / 2, -0.22, 0.92], [foot, -0.37, 1.0], [1.12 * foot, -0.385, 1.1]];
      addTube(mesh, part.gloss, mirrored(leg, side), 0.05, 0.016);
    }
  }
  addSurface(mesh, [32, 48], part.lut, (u, v) => {
    const [angle, dome] = [1.16 * Math.PI * (v - 0.5), (1 - Math.abs(1.8 * u - 0.88) ** 3.4) ** (1 / 3.4)];
    const width = (0.53 - 0.17 * u * u) * (0.55 + 0.45 * dome);
    return [0.44 + 0.47 * u, (0.44 - 0.13 * u) * dome * Math.cos(angle), width * Math.sin(angle)];
  });
  addEllipsoid(mesh, [40, 24], part.lut, [0.95, 0.02, 0], [0.17, 0.15, 0.2]);
  addEllipsoid(mesh, [40, 24], part.gloss, [-0.2, -0.06, 0], [0.95, 0.2, 0.5]);
}

/** Right wings, in their plane: from the body along the front edge to the tip, and back along the margin. */
const outline = (points: [number, number][]): ((t: number) => Point) => path(points.map(([x, y]) => [x, y, 0]));
const forewing = outline([[0.05, 0.06], [0.3, 0.4], [0.62, 0.66], [0.9, 0.8], [1.07, 0.83], [1.11, 0.74], [1.06, 0.54],
  [1.0, 0.34], [0.97, 0.14], [0.93, 0.0], [0.84, -0.09], [0.6, -0.1], [0.3, -0.06], [0.05, 0.0]]);
const hindwing = outline([[0.05, 0.03], [0.36, 0.1], [0.66, 0.09], [0.86, -0.02], [0.95, -0.22], [0.92, -0.46],
  [0.79, -0.69], [0.6, -0.86], [0.43, -0.94], [0.28, -0.9], [0.17, -0.68], [0.09, -0.34], [0.05, -0.03]]);

function addWing(mesh: Mesh, side: number, isFore: boolean): void {
  const at = (u: number, v: number): Point => {
    const [x, y] = (isFore ? forewing : hindwing)(u);
    const wave = Math.cos(2 * Math.PI * (isFore ? 17 : 19) * u); // veins all around, as in shader_parts.ts
    const r = v * (1 + (isFore ? 0.004 : 0.014) * wave * (u > 0.25 && u < 0.85 ? 1 : 0));
    const [px, py] = [0.05 + (x - 0.05) * r, 0.02 + (y - 0.02) * r];
    const bulge = 0.07 * Math.sin(Math.PI * Math.min(r, 1)) + 0.0016 * r * wave;
    return [side * px, py, 0.16 * px + bulge + (isFore ? 0.02 : 0)];
  };
  addSurface(mesh, [100, 18], part.wing, at, (u, v, [x, y]) => [x, y, u + (isFore ? 0 : 2), v]);
}

function addButterfly(mesh: Mesh): void {
  for (const side of [-1, 1]) {
    addWing(mesh, side, false);
    addWing(mesh, side, true);
    const antenna: Point[] = [[0.02, 0.3, 0.06], [0.1, 0.48, 0.09], [0.22, 0.66, 0.1], [0.31, 0.75, 0.1]];
    addTube(mesh, part.matte, antenna.map(([x, y, z]) => [side * x, y, z]), 0.007, 0.012);
  }
  addEllipsoid(mesh, [32, 20], part.matte, [0, 0.08, 0.03], [0.075, 0.17, 0.075]);
  addEllipsoid(mesh, [32, 20], part.matte, [0, -0.3, 0.02], [0.05, 0.31, 0.05]);
  addEllipsoid(mesh, [24, 16], part.matte, [0, 0.27, 0.05], [0.055, 0.06, 0.055]);
}

/** A car's body: at every x, from tail to nose, a round section. Metres. */
const half = 2.2;
const bodyTop = spline([-2.2, -1.9, -1.2, -0.2, 0.8, 1.4, 1.9, 2.2], [0.86, 0.93, 0.93, 0.88, 0.86, 0.79, 0.66, 0.54]);
const roofTop = spline([-2.2, -1.8, -1.2, -0.5, 0.1, 0.6, 1.05, 1.5, 2.2],
  [0.72, 0.88, 1.12, 1.27, 1.25, 1.06, 0.8, 0.6, 0.46]);
const halfWidth = spline([-2.2, -1.7, -1.25, -0.2, 0.5, 1.3, 1.8, 2.2], [0.8, 0.9, 0.95, 0.88, 0.88, 0.93, 0.86, 0.7]);
const roofWidth = spline([-2.2, -1.2, -0.3, 0.6, 2.2], [0.5, 0.64, 0.68, 0.7, 0.6]);
const middle = 0.48;

function carBody(u: number, v: number): Point {
  const x = half * Math.sin(Math.PI * (u - 0.5));
  const [y, z] = ring(1, v + 0.25).reverse() as [number, number];
  const round = (width: number, height: number, power: number): number =>
    (Math.abs(z / width) ** power + Math.abs(y / height) ** power) ** (-1 / power);
  const closing = (1 - Math.min(1, Math.abs(x) / half) ** 8) ** (1 / 3.2);
  const body = round(halfWidth(x), y < 0 ? 0.3 : bodyTop(x) - middle, y < 0 ? 3.4 : 3);
  const roof = y < 0 ? 0 : round(roofWidth(x), Math.max(roofTop(x) - middle, 0.05), 2.6);
  const radius = closing * (body ** 14 + roof ** 14) ** (1 / 14);
  return [x, middle + radius * y, radius * z];
}

function addCar(mesh: Mesh): void {
  addSurface(mesh, [128, 88], part.car, carBody, (_u, _v, point) => [...point, 0]);
  const rings = [[0.33, 0.6, part.matte], [0.33, 0.91, part.matte], [0.315, 0.95, part.matte],
    [0.265, 0.95, part.metal], [0.25, 0.93, part.gloss], [0, 0.92, part.gloss]] as const;
  for (const [x, side] of [[-1.32, -1], [-1.32, 1], [1.32, -1], [1.32, 1]] as const) {
    const place = ([a, b]: [number, number], depth: number): Point => [x + a, 0.33 + b, side * depth];
    for (const [i, [r, z, kind]] of rings.slice(0, -1).entries()) {
      const [nextR, nextZ] = rings[i + 1]!;
      addSurface(mesh, [48, 1], kind, (u, v) => place(ring(r + (nextR - r) * v, u), z + (nextZ - z) * v));
    }
    for (let spoke = 0; spoke < 10; ++spoke) {
      const across = (u: number, v: number): number => ((u - 0.5) * (0.06 - 0.02 * v)) / (0.3 + v);
      addSurface(mesh, [4, 4], part.metal, (u, v) => place(ring(0.02 + 0.235 * v, spoke / 10 + across(u, v)),
        0.94 - 0.04 * (u - 0.5) ** 2));
    }
  }
  const scale = 0.62;
  mesh.vertices = mesh.vertices.map((v, i) => (i % 11 < 3 ? scale * (v - (i % 11 === 1 ? 0.66 : 0)) : v));
}

const addBall = (mesh: Mesh): void => addEllipsoid(mesh, [96, 48], part.lut, [0, 0, 0], [1, 1, 1]);
const none: [number, number] = [1e-3, 1e-3];
const makers: Record<ObjectName, [(mesh: Mesh) => void, Omit<ShownObject, "mesh">]> = {
  sphere: [addBall, { turn: 0, pitch: 8, reach: [1.2, 1.34], floor: -1, shade: [1, 1] }],
  bubble: [addBall, { turn: 0, pitch: 4, reach: [1.2, 1.34], floor: -1, shade: none }],
  wing: [addButterfly, { turn: -14, pitch: 10, reach: [1.3, 1.1], floor: -1.25, shade: none }],
  elytra: [addBeetle, { turn: -128, pitch: 40, reach: [1.5, 1.3], floor: -0.4, shade: [1.0, 0.62] }],
  car: [addCar, { turn: -38, pitch: 11, reach: [1.5, 0.92], floor: -0.41, shade: [1.36, 0.56] }],
  disc: [addDisc, { turn: 0, pitch: 58, reach: [1.15, 1.12], floor: -0.03, shade: [0.97, 0.97] }],
};
const made = new Map<ObjectName, ShownObject>();

/** Each object is made once, when it is first shown. */
export function shownObject(name: ObjectName): ShownObject {
  const known = made.get(name);
  if (known) return known;
  const [add, rest] = makers[name];
  const object = { mesh: { vertices: [], indices: [] }, ...rest };
  add(object.mesh);
  made.set(name, object);
  return object;
}
