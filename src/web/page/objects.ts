// The objects that the output window shows, made by code. All shapes are drawn by eye.

import { addEllipsoid, addSurface, addTube, emptyMesh, part, path, spline } from "./surfaces";
import type { Mesh, Point } from "./surfaces";

export type ObjectName = "sphere" | "wing" | "elytra" | "car" | "bubble" | "disc";

/** An object, how it stands, and from where it is first seen. */
export interface ShownObject {
  mesh: Mesh;
  /** First turn around the vertical and height of the camera, in degrees, and half of the picture's height. */
  turn: number;
  pitch: number;
  reach: number;
  /** Half of the width that must be in the picture. */
  wide: number;
  /** Height of the floor, and half the length and width of the object's shade on it. */
  floor: number;
  shade: [number, number];
}

const mirror = (point: Point, side: number): Point => [point[0], point[1], side * point[2]];

function ball(): Mesh {
  const mesh = emptyMesh();
  addEllipsoid(mesh, [128, 64], part.lut, [0, 0, 0], [1, 1, 1]);
  return mesh;
}

function disc(): Mesh {
  const mesh = emptyMesh();
  const hole = 0.125; // of a radius of 60 mm
  addSurface(
    mesh,
    [160, 4],
    part.disc,
    (u, v) => {
      const radius = hole + (1 - hole) * v;
      return [radius * Math.cos(2 * Math.PI * u), 0, radius * Math.sin(2 * Math.PI * u)];
    },
    (_u, v) => [hole + (1 - hole) * v, 0, 0, 0],
  );
  for (const radius of [hole, 1]) {
    addSurface(mesh, [160, 1], part.gloss, (u, v) => {
      return [radius * Math.cos(2 * Math.PI * u), -0.018 * v, radius * Math.sin(2 * Math.PI * u)];
    });
  }
  return mesh;
}

/** One wing case: from the shoulder to the tail, and from the seam down to the side. */
function addElytron(mesh: Mesh, side: number): void {
  const width = spline([0, 0.12, 0.45, 0.75, 1], [0.5, 0.565, 0.63, 0.6, 0.52]);
  const height = spline([0, 0.3, 0.6, 1], [0.4, 0.5, 0.49, 0.4]);
  addSurface(
    mesh,
    [96, 64],
    part.elytron,
    (u, v) => {
      const tail = Math.max(0, (u - 0.3) / 0.7);
      const closing = (1 - tail ** 2.3) ** (1 / 2.3);
      const shoulder = 1 - 0.25 * Math.max(0, 1 - u / 0.07) ** 2;
      const angle = 0.58 * Math.PI * v;
      const seam = 0.02 * Math.exp(-((v / 0.035) ** 2));
      const z = width(u) * closing * Math.sin(angle) ** 0.94 + 0.002;
      const y = height(u) * closing * shoulder * Math.cos(angle) - seam;
      return mirror([0.45 - 1.5 * u, y, z], side);
    },
    (u, v) => [u, v, side, 0],
  );
}

function beetle(): Mesh {
  const mesh = emptyMesh();
  const closed = (t: number, power: number): number => Math.max(0, 1 - Math.abs(2 * t - 1) ** power) ** (1 / power);
  for (const side of [-1, 1]) {
    addElytron(mesh, side);
    addTube(mesh, part.gloss, [[1.03, 0.06, 0.07], [1.2, 0.2, 0.2], [1.32, 0.22, 0.42], [1.36, 0.16, 0.62]].map((p) =>
      mirror(p as Point, side)), 0.02, 0.012);
    addEllipsoid(mesh, [20, 14], part.gloss, mirror([0.98, 0.06, 0.17], side), [0.07, 0.075, 0.06]);
    for (const [x, knee, foot] of [[0.55, 0.8, 1.02], [0.15, 0.18, 0.22], [-0.25, -0.62, -1.0]] as const) {
      addTube(mesh, part.gloss, [[x, -0.16, 0.3], [(x + knee) / 2, -0.02, 0.62], [knee, 0.02, 0.8],
        [(knee + foot) / 2, -0.22, 0.92], [foot, -0.37, 1.0], [1.12 * foot, -0.385, 1.1]].map((p) =>
        mirror(p as Point, side)), 0.05, 0.016);
    }
  }
  addSurface(mesh, [48, 64], part.lut, (u, v) => {
    const [a, dome] = [1.16 * Math.PI * (v - 0.5), closed(0.06 + 0.9 * u, 3.4)];
    const width = (0.53 - 0.17 * u * u) * (0.55 + 0.45 * dome);
    return [0.44 + 0.47 * u, (0.44 - 0.13 * u) * dome * Math.cos(a), width * Math.sin(a)];
  });
  addEllipsoid(mesh, [40, 24], part.lut, [0.95, 0.02, 0], [0.17, 0.15, 0.2]);
  addEllipsoid(mesh, [40, 24], part.gloss, [-0.2, -0.06, 0], [0.95, 0.2, 0.5]);
  return mesh;
}

/** Right wings, in their plane: from the body along the front edge to the tip, and back along the margin. */
const forewing = path([[0.05, 0.06], [0.3, 0.4], [0.62, 0.66], [0.9, 0.8], [1.07, 0.83], [1.11, 0.74], [1.06, 0.54],
  [1.0, 0.34], [0.97, 0.14], [0.93, 0.0], [0.84, -0.09], [0.6, -0.1], [0.3, -0.06], [0.05, 0.0]]);
const hindwing = path([[0.05, 0.03], [0.36, 0.1], [0.66, 0.09], [0.86, -0.02], [0.95, -0.22], [0.92, -0.46],
  [0.79, -0.69], [0.6, -0.86], [0.43, -0.94], [0.28, -0.9], [0.17, -0.68], [0.09, -0.34], [0.05, -0.03]]);

function addWing(mesh: Mesh, side: number, isFore: boolean): void {
  const outline = isFore ? forewing : hindwing;
  const cells = isFore ? 17 : 19; // between veins all around
  addSurface(
    mesh,
    [144, 32],
    part.wing,
    (u, v) => {
      const [x, y] = outline(u) as [number, number];
      const scallop = 1 + (isFore ? 0.004 : 0.014) * Math.cos(2 * Math.PI * cells * u) * (u > 0.25 && u < 0.85 ? 1 : 0);
      const r = v * scallop;
      const [px, py] = [0.05 + (x - 0.05) * r, 0.02 + (y - 0.02) * r];
      const bulge = 0.07 * Math.sin(Math.PI * Math.min(r, 1)) + 0.0016 * r * Math.cos(2 * Math.PI * cells * u);
      return [side * px, py, 0.16 * px + bulge + (isFore ? 0.02 : 0)];
    },
    (u, v, point) => [side * point[0], point[1], u + (isFore ? 0 : 2), v],
  );
}

function butterfly(): Mesh {
  const mesh = emptyMesh();
  for (const side of [-1, 1]) {
    addWing(mesh, side, false);
    addWing(mesh, side, true);
    addTube(mesh, part.matte, [[0.02, 0.3, 0.06], [0.1, 0.48, 0.09], [0.22, 0.66, 0.1], [0.31, 0.75, 0.1]].map((p) =>
      [side * p[0]!, p[1]!, p[2]!] as Point), 0.007, 0.012);
  }
  addEllipsoid(mesh, [32, 20], part.matte, [0, 0.08, 0.03], [0.075, 0.17, 0.075]);
  addEllipsoid(mesh, [32, 20], part.matte, [0, -0.3, 0.02], [0.05, 0.31, 0.05]);
  addEllipsoid(mesh, [24, 16], part.matte, [0, 0.27, 0.05], [0.055, 0.06, 0.055]);
  return mesh;
}

/** The body: half the length along x, and at every x a round section. Metres. */
const carHalf = 2.2;
const bodyTop = spline([-2.2, -1.9, -1.2, -0.2, 0.8, 1.4, 1.9, 2.2], [0.86, 0.93, 0.93, 0.88, 0.86, 0.79, 0.66, 0.54]);
const roofTop = spline([-2.2, -1.8, -1.2, -0.5, 0.1, 0.6, 1.05, 1.5, 2.2],
  [0.72, 0.88, 1.12, 1.27, 1.25, 1.06, 0.8, 0.6, 0.46]);
const halfWidth = spline([-2.2, -1.7, -1.25, -0.2, 0.5, 1.3, 1.8, 2.2], [0.8, 0.9, 0.95, 0.88, 0.88, 0.93, 0.86, 0.7]);
const roofWidth = spline([-2.2, -1.2, -0.3, 0.6, 2.2], [0.5, 0.64, 0.68, 0.7, 0.6]);

function carSection(x: number, angle: number): [number, number] {
  const end = Math.min(1, Math.abs(x) / carHalf);
  const closing = (1 - end ** 8) ** (1 / 3.2);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const middle = 0.48;
  const round = (width: number, height: number, power: number): number =>
    (Math.abs(c / width) ** power + Math.abs(s / height) ** power) ** (-1 / power);
  if (s < 0) return [closing * round(halfWidth(x), 0.3, 3.4) * s + middle, closing * round(halfWidth(x), 0.3, 3.4) * c];
  const body = round(halfWidth(x), bodyTop(x) - middle, 3);
  const roof = round(roofWidth(x), Math.max(roofTop(x) - middle, 0.05), 2.6);
  const radius = closing * (body ** 14 + roof ** 14) ** (1 / 14);
  return [radius * s + middle, radius * c];
}

function addWheel(mesh: Mesh, x: number, side: number): void {
  const rim = (radius: number, depth: number) => (u: number): Point =>
    [x + radius * Math.cos(2 * Math.PI * u), 0.33 + radius * Math.sin(2 * Math.PI * u), side * depth];
  const rings: [number, number, number][] = [[0.33, 0.6, part.matte], [0.33, 0.91, part.matte], [0.315, 0.95, part.matte],
    [0.265, 0.95, part.metal], [0.25, 0.93, part.gloss], [0, 0.92, part.gloss]];
  for (let i = 0; i + 1 < rings.length; ++i) {
    const [[r0, z0, kind], [r1, z1]] = [rings[i]!, rings[i + 1]!];
    addSurface(mesh, [48, 1], kind, (u, v) => rim(r0 + (r1 - r0) * v, z0 + (z1 - z0) * v)(u));
  }
  for (let spoke = 0; spoke < 10; ++spoke) {
    addSurface(mesh, [4, 4], part.metal, (u, v) => {
      const [along, across] = [0.02 + 0.235 * v, (u - 0.5) * (0.06 - 0.02 * v)];
      const [c, s] = [Math.cos((2 * Math.PI * spoke) / 10), Math.sin((2 * Math.PI * spoke) / 10)];
      const depth = 0.94 - 1.2 * across * across * 10;
      return [x + along * c - across * s, 0.33 + along * s + across * c, side * depth];
    });
  }
}

function car(): Mesh {
  const mesh = emptyMesh();
  addSurface(
    mesh,
    [180, 128],
    part.car,
    (u, v) => {
      const x = carHalf * Math.sin(Math.PI * (u - 0.5));
      const [y, z] = carSection(x, 2 * Math.PI * v + Math.PI / 2);
      return [x, y, z];
    },
    (_u, _v, [x, y, z]) => [x, y, z, 0],
  );
  for (const x of [-1.32, 1.32]) for (const side of [-1, 1]) addWheel(mesh, x, side);
  const scale = 0.62;
  mesh.vertices = mesh.vertices.map((value, i) => {
    return i % 11 < 3 ? scale * (value - (i % 11 === 1 ? 0.66 : 0)) : value;
  });
  return mesh;
}

const makers: Record<ObjectName, () => ShownObject> = {
  sphere: () => ({ mesh: ball(), turn: 0, pitch: 8, reach: 1.34, wide: 1.2, floor: -1, shade: [1, 1] }),
  bubble: () => ({ mesh: ball(), turn: 0, pitch: 4, reach: 1.34, wide: 1.2, floor: -1, shade: [1e-3, 1e-3] }),
  wing: () => ({ mesh: butterfly(), turn: -14, pitch: 10, reach: 1.1, wide: 1.3, floor: -1.25, shade: [1e-3, 1e-3] }),
  elytra: () => ({ mesh: beetle(), turn: -128, pitch: 40, reach: 1.2, wide: 1.5, floor: -0.4, shade: [1.0, 0.62] }),
  car: () => ({ mesh: car(), turn: -38, pitch: 11, reach: 0.92, wide: 1.5, floor: -0.41, shade: [1.36, 0.56] }),
  disc: () => ({ mesh: disc(), turn: 0, pitch: 58, reach: 1.12, wide: 1.15, floor: -0.03, shade: [0.97, 0.97] }),
};
const made = new Map<ObjectName, ShownObject>();

/** Each object is made once, when it is first shown. */
export function shownObject(name: ObjectName): ShownObject {
  const known = made.get(name) ?? makers[name]();
  made.set(name, known);
  return known;
}
