// From where the object is seen and lit, and how pointer, wheel and keys change that.

import type { ShownObject } from "./objects";
import type { Point } from "./surfaces";

const degree = Math.PI / 180;
const far = 7; // from the eye to the middle of the object, whose radius is about 1

export const clamped = (value: number, from: number, to: number): number => Math.min(Math.max(value, from), to);

/** Direction to a light: around from the viewer to the right, and up. */
export function direction([around, up]: [number, number]): Point {
  const [a, b] = [around * degree, up * degree];
  return [Math.sin(a) * Math.cos(b), Math.sin(b), Math.cos(a) * Math.cos(b)];
}

export interface Eye {
  from: Point;
  right: Point;
  up: Point;
  forward: Point;
  /** Half the picture's width and height at distance 1. */
  half: [number, number];
}

export function eyeOf(object: ShownObject, pitch: number, zoom: number, aspect: number): Eye {
  const half = Math.max(object.reach, object.wide / aspect) / zoom / far;
  const [c, s] = [Math.cos(pitch * degree), Math.sin(pitch * degree)];
  return {
    from: [0, far * s, far * c],
    right: [1, 0, 0],
    up: [0, c, -s],
    forward: [0, -s, -c],
    half: [half * aspect, half],
  };
}

const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Column by column, as WebGL takes it. */
export function viewMatrix({ from, right, up, forward, half }: Eye): number[] {
  const [near, end] = [2, 20];
  const rows = [
    [...right.map((value) => value / half[0]), -dot(right, from) / half[0]],
    [...up.map((value) => value / half[1]), -dot(up, from) / half[1]],
    [...forward.map((value) => (value * (end + near)) / (end - near)), 0],
    [...forward, -dot(forward, from)],
  ];
  rows[2]![3] = (-dot(forward, from) * (end + near) - 2 * end * near) / (end - near);
  return [0, 1, 2, 3].flatMap((column) => rows.map((row) => row[column]!));
}

/** Where a point is on the picture, from -1 to 1, y up. */
export function onPicture({ from, right, up, forward, half }: Eye, point: Point): [number, number] {
  const way = point.map((value, axis) => value - from[axis]!) as Point;
  const depth = dot(way, forward);
  return [dot(way, right) / depth / half[0], dot(way, up) / depth / half[1]];
}

/** What the pointer and the keys change. */
export interface Handles {
  turned(right: number, up: number): void;
  zoomed(factor: number): void;
  lightMoved(right: number, up: number): void;
  reset(): void;
  /** Whether the light's marker is there, in CSS pixels from the upper left. */
  isOnLight(x: number, y: number): boolean;
}

const degreesPerPixel = 0.4;

function listenToPointers(canvas: HTMLCanvasElement, handles: Handles): void {
  const down = new Map<number, [number, number]>();
  let isLight = false;
  const spread = (): number => {
    const [a, b] = [...down.values()];
    return a && b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (down.size === 0) {
      isLight = event.button === 2 || event.shiftKey || handles.isOnLight(event.offsetX, event.offsetY);
    }
    down.set(event.pointerId, [event.clientX, event.clientY]);
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    if (!before) {
      canvas.style.cursor = handles.isOnLight(event.offsetX, event.offsetY) ? "move" : "grab";
      return;
    }
    const apart = spread();
    down.set(event.pointerId, [event.clientX, event.clientY]);
    if (down.size === 2) {
      if (apart > 0) handles.zoomed(spread() / apart);
      return;
    }
    const right = degreesPerPixel * (event.clientX - before[0]);
    const up = degreesPerPixel * (before[1] - event.clientY);
    if (isLight) handles.lightMoved(right, up);
    else handles.turned(right, up);
  });
  for (const end of ["pointerup", "pointercancel"] as const) {
    canvas.addEventListener(end, (event) => down.delete(event.pointerId));
  }
}

export function listen(canvas: HTMLCanvasElement, handles: Handles): void {
  canvas.tabIndex = 0;
  canvas.style.touchAction = "none";
  listenToPointers(canvas, handles);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("dblclick", () => handles.reset());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 0 ? 1 : 16; // pixels of a line
    handles.zoomed(Math.exp(-0.0015 * lines * event.deltaY));
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => {
    const move = event.shiftKey ? handles.lightMoved : handles.turned;
    const keys: Record<string, () => void> = {
      ArrowLeft: () => move(-5, 0),
      ArrowRight: () => move(5, 0),
      ArrowUp: () => move(0, 5),
      ArrowDown: () => move(0, -5),
      "+": () => handles.zoomed(1.1),
      "=": () => handles.zoomed(1.1),
      "-": () => handles.zoomed(1 / 1.1),
      Home: () => handles.reset(),
    };
    const action = keys[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  });
}
