// From where the object is seen and lit, and how pointer, wheel and keys change that.

import type { ShownObject } from "./objects";
import type { OutputView } from "./output";
import { dot, type Point } from "./surfaces";

const degree = Math.PI / 180;
const far = 7; // from the eye to the middle of the object, whose radius is about 1
export const clamped = (value: number, from: number, to: number): number => Math.min(Math.max(value, from), to);

/** Direction to a light: around from the viewer to the right, and up. */
export function direction([around, up]: [number, number]): Point {
  const [a, b] = [around * degree, up * degree];
  return [Math.sin(a) * Math.cos(b), Math.sin(b), Math.cos(a) * Math.cos(b)];
}

/** The camera looks at the middle from (0, y, z). */
export class Eye {
  readonly right: Point = [1, 0, 0];
  readonly from: Point;
  readonly up: Point;
  readonly forward: Point;
  /** Half the picture's width and height at distance 1. */
  readonly half: [number, number];

  constructor(object: ShownObject, pitch: number, zoom: number, aspect: number) {
    const half = Math.max(object.reach[1], object.reach[0] / aspect) / zoom / far;
    const [c, s] = [Math.cos(pitch * degree), Math.sin(pitch * degree)];
    [this.from, this.up, this.forward] = [[0, far * s, far * c], [0, c, -s], [0, -s, -c]];
    this.half = [half * aspect, half];
  }

  /** For depths of 2 to 20, column by column, as WebGL takes it. */
  matrix(): number[] {
    const { right, up, forward, half } = this;
    const depth = forward.map((v) => (v * 22) / 18);
    const rows = [right.map((v) => v / half[0]), up.map((v) => v / half[1]), depth, forward];
    return [...[0, 1, 2].flatMap((column) => rows.map((row) => row[column]!)), 0, 0, (far * 22 - 80) / 18, far];
  }

  /** Where a point is on the picture, from -1 to 1, y up. */
  onPicture(point: Point): [number, number] {
    const depth = far + dot(point, this.forward);
    return [dot(point, this.right) / depth / this.half[0], dot(point, this.up) / depth / this.half[1]];
  }
}

/** What the pointer and the keys change. */
type Handles = Pick<OutputView, "turned" | "lightMoved" | "zoomed" | "reset" | "isOnLight">;
const degreesPerPixel = 0.4;

function listenToPointers(canvas: HTMLCanvasElement, handles: Handles): void {
  const down = new Map<number, [number, number]>();
  let moved: "turned" | "lightMoved" = "turned";
  const spread = (): number => {
    const [a, b] = [...down.values()];
    return a && b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
  };
  canvas.addEventListener("pointerdown", (event) => {
    const isLight = event.button === 2 || event.shiftKey || handles.isOnLight(event.offsetX, event.offsetY);
    if (down.size === 0) moved = isLight ? "lightMoved" : "turned";
    down.set(event.pointerId, [event.clientX, event.clientY]);
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    if (!before) return;
    const apart = spread();
    down.set(event.pointerId, [event.clientX, event.clientY]);
    if (apart > 0) handles.zoomed(spread() / apart);
    else handles[moved](degreesPerPixel * (event.clientX - before[0]), degreesPerPixel * (before[1] - event.clientY));
  });
  canvas.addEventListener("pointerup", (event) => down.delete(event.pointerId));
  canvas.addEventListener("pointercancel", (event) => down.delete(event.pointerId));
}

export function listen(canvas: HTMLCanvasElement, handles: Handles): void {
  canvas.tabIndex = 0;
  canvas.style.touchAction = "none";
  listenToPointers(canvas, handles);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("dblclick", () => handles.reset());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    handles.zoomed(Math.exp(-0.0015 * event.deltaY * (event.deltaMode === 0 ? 1 : 16))); // pixels of a line
  }, { passive: false });
  const arrows: Record<string, [number, number]> = {
    ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5],
  };
  const zooms: Record<string, number> = { "+": 1.1, "=": 1.1, "-": 1 / 1.1 };
  canvas.addEventListener("keydown", (event) => {
    const [arrow, zoom] = [arrows[event.key], zooms[event.key]];
    if (event.ctrlKey || event.metaKey || event.altKey || !(arrow || zoom || event.key === "Home")) return;
    event.preventDefault();
    if (arrow) handles[event.shiftKey ? "lightMoved" : "turned"](...arrow);
    else if (zoom) handles.zoomed(zoom);
    else handles.reset();
  });
}
