// A plane with two axes, a field of colours behind it and squares to drag: the plane of peak and angle, and the palette.

import { clamp, el, svg } from "./dom";

export interface PlotAxis {
  label: string;
  from: number;
  to: number;
  ticks: number[];
  unit: string;
  /** Squares move in these steps, and with Shift in leaps. */
  step: number;
  leap: number;
}

export interface Square {
  x: number;
  y: number;
  colour: string;
  name: string;
  /** What stands beside it; screen readers say it too. */
  text: string;
  isSelected: boolean;
}

export interface PlotHandlers {
  move(square: number, x: number, y: number, gesture: string): void;
  select(square: number): void;
  add?(x: number, y: number): void;
  remove?(square: number): void;
}

const margin = { left: 44, right: 14, top: 12, bottom: 38 };
let gestures = 0;

export class Plot {
  readonly element: HTMLElement;
  /** Colours; as many pixels as its owner likes, drawn smoothly over the plane. */
  readonly field = el("canvas", { class: "field", "aria-hidden": "true" });
  /** For curves, below the squares. */
  readonly curves = svg("g");
  /** Called when the size has changed, after the axes are drawn. */
  onLayout: () => void = () => {};

  private readonly frame = svg("g", { class: "frame" });
  private readonly squares = svg("g");
  private readonly picture = svg("svg", { role: "group" });
  private shown: Square[] = [];
  private width = 0;
  private height = 0;

  constructor(
    name: string,
    readonly x: PlotAxis,
    readonly y: PlotAxis,
    private readonly handlers: PlotHandlers,
  ) {
    this.picture.setAttribute("aria-label", name);
    this.picture.append(this.frame, this.curves, this.squares);
    this.element = el("div", { class: "plot" }, this.field, this.picture);
    this.picture.addEventListener("dblclick", (event) => {
      const at = this.valuesAt(event);
      this.handlers.add?.(at.x, at.y);
    });
    new ResizeObserver(() => this.layout()).observe(this.element);
  }

  px(value: number): number {
    const share = (value - this.x.from) / (this.x.to - this.x.from);
    return margin.left + share * (this.width - margin.left - margin.right);
  }

  py(value: number): number {
    const share = (value - this.y.from) / (this.y.to - this.y.from);
    return this.height - margin.bottom - share * (this.height - margin.top - margin.bottom);
  }

  layout(): void {
    this.width = this.element.clientWidth;
    this.height = this.element.clientHeight;
    if (this.width < 80 || this.height < 80) return;
    this.picture.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    const [left, right] = [this.px(this.x.from), this.px(this.x.to)];
    const [bottom, top] = [this.py(this.y.from), this.py(this.y.to)];
    this.field.style.cssText = `left:${left}px;top:${top}px;width:${right - left}px;height:${bottom - top}px`;
    this.frame.replaceChildren(svg("rect", { x: left, y: top, width: right - left, height: bottom - top }));
    for (const tick of this.x.ticks) {
      const x = this.px(tick);
      this.frame.append(svg("path", { d: `M${x} ${bottom}v5` }), svg("text", { x, y: bottom + 17 }, String(tick)));
    }
    for (const tick of this.y.ticks) {
      const y = this.py(tick);
      const label = svg("text", { x: left - 8, y: y + 4, class: "end" }, `${tick}${this.y.unit === "°" ? "°" : ""}`);
      this.frame.append(svg("path", { d: `M${left} ${y}h-5` }), label);
    }
    this.frame.append(svg("text", { x: right, y: bottom + 33, class: "end label" }, this.x.label));
    this.frame.append(svg("text", { x: left + 8, y: top + 17, class: "start label over" }, this.y.label));
    this.onLayout();
    this.show(this.shown);
  }

  show(squares: Square[]): void {
    this.shown = squares;
    while (this.squares.childNodes.length > squares.length) this.squares.lastChild!.remove();
    while (this.squares.childNodes.length < squares.length) this.squares.append(this.newSquare());
    squares.forEach((square, i) => this.place(this.squares.childNodes[i] as SVGGElement, square));
  }

  focusSquare(square: number): void {
    (this.squares.childNodes[square] as SVGGElement | undefined)?.focus();
  }

  private place(group: SVGGElement, square: Square): void {
    const x = clamp(this.px(square.x), this.px(this.x.from), this.px(this.x.to));
    const y = clamp(this.py(square.y), this.py(this.y.to), this.py(this.y.from));
    group.setAttribute("transform", `translate(${x} ${y})`);
    group.setAttribute("class", square.isSelected ? "square selected" : "square");
    group.setAttribute("aria-label", square.name);
    group.setAttribute("aria-valuetext", square.text);
    group.setAttribute("aria-valuenow", String(square.x));
    group.setAttribute("aria-valuemin", String(this.x.from));
    group.setAttribute("aria-valuemax", String(this.x.to));
    (group.querySelector(".inside") as SVGElement).setAttribute("fill", square.colour);
    const label = group.querySelector("text")!;
    const isLeft = x > this.width - 150;
    label.textContent = square.text;
    label.setAttribute("x", isLeft ? "-16" : "16");
    label.setAttribute("y", y < margin.top + 16 ? "16" : y > this.height - margin.bottom - 14 ? "-12" : "5");
    label.setAttribute("class", isLeft ? "end" : "start");
  }

  private newSquare(): SVGGElement {
    const group = svg("g", { tabindex: 0, role: "slider" });
    const box = (half: number, name: string): SVGRectElement =>
      svg("rect", { x: -half, y: -half, width: 2 * half, height: 2 * half, class: name });
    group.append(box(18, "touch"), box(12, "ring"), box(8, "outside"), box(8, "inside"), svg("text"));
    group.addEventListener("pointerdown", (event) => this.grab(group, event));
    group.addEventListener("focus", () => this.handlers.select(this.indexOf(group)));
    group.addEventListener("keydown", (event) => this.pressed(this.indexOf(group), event));
    group.addEventListener("dblclick", (event) => event.stopPropagation());
    return group;
  }

  private indexOf(group: SVGGElement): number {
    return [...this.squares.childNodes].indexOf(group);
  }

  private valuesAt(event: MouseEvent): { x: number; y: number } {
    const box = this.picture.getBoundingClientRect();
    const across = (event.clientX - box.left - margin.left) / (this.width - margin.left - margin.right);
    const up = (box.bottom - event.clientY - margin.bottom) / (this.height - margin.top - margin.bottom);
    return this.rounded(
      this.x.from + across * (this.x.to - this.x.from),
      this.y.from + up * (this.y.to - this.y.from),
    );
  }

  private rounded(x: number, y: number): { x: number; y: number } {
    const onAxis = (value: number, axis: PlotAxis): number =>
      Number((Math.round(clamp(value, axis.from, axis.to) / axis.step) * axis.step).toFixed(4));
    return { x: onAxis(x, this.x), y: onAxis(y, this.y) };
  }

  private grab(group: SVGGElement, event: PointerEvent): void {
    if (event.button !== 0) return;
    event.preventDefault();
    group.focus({ preventScroll: true });
    const index = this.indexOf(group);
    const gesture = `drag ${++gestures}`;
    const pressed = { x: event.clientX, y: event.clientY };
    const square = this.shown[index]!;
    const from = { x: this.px(square.x), y: this.py(square.y) };
    const box = this.picture.getBoundingClientRect();
    const move = (at: PointerEvent): void => {
      const clientX = box.left + from.x + at.clientX - pressed.x;
      const clientY = box.top + from.y + at.clientY - pressed.y;
      const to = this.valuesAt({ clientX, clientY } as MouseEvent);
      const now = this.shown[index];
      if (now && (to.x !== now.x || to.y !== now.y)) this.handlers.move(index, to.x, to.y, gesture);
    };
    const release = (): void => {
      group.removeEventListener("pointermove", move);
      group.removeEventListener("pointerup", release);
      group.removeEventListener("pointercancel", release);
    };
    group.setPointerCapture(event.pointerId);
    group.addEventListener("pointermove", move);
    group.addEventListener("pointerup", release);
    group.addEventListener("pointercancel", release);
  }

  private pressed(index: number, event: KeyboardEvent): void {
    const ways: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowDown: [0, -1],
      ArrowUp: [0, 1],
    };
    const way = ways[event.key];
    const square = this.shown[index]!;
    if (way) {
      const size = event.shiftKey ? "leap" : "step";
      const to = this.rounded(square.x + way[0] * this.x[size], square.y + way[1] * this.y[size]);
      this.handlers.move(index, to.x, to.y, `keys ${index}`);
    } else if (event.key === "Enter") this.handlers.add?.(square.x, square.y);
    else if (event.key === "Delete" || event.key === "Backspace") this.handlers.remove?.(index);
    else return;
    event.preventDefault();
  }
}
