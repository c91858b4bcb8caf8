// Two axes, a field of colours behind them and squares to drag: the plane of peak and angle, and the palette.

import { byId, clamp, el, set, svg } from "./dom";

export interface PlotAxis {
  label: string;
  from: number;
  to: number;
  ticks: number[];
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
  select?(square: number): void;
  add?(x: number, y: number): void;
  remove?(square: number): void;
}

const margin = { left: 44, right: 14, top: 12, bottom: 38 };
const arrows: Record<string, [number, number]> = {
  ...{ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] },
};
let gestures = 0;

export class Plot {
  /** Colours; as many pixels as its owner likes, drawn smoothly over the plane. */
  readonly field = el("canvas", { class: "field", "aria-hidden": "true" });
  /** For curves, below the squares. */
  readonly curves = svg("g");

  private readonly frame = svg("g", { class: "frame" });
  private readonly squares = svg("g");
  private readonly picture = svg("svg", { role: "group" });
  private shown: Square[] = [];
  private width = 0;
  private height = 0;

  /** @param home  the id of the element that it fills
   *  @param drawCurves  called when the size has changed */
  constructor(
    home: string,
    name: string,
    readonly x: PlotAxis,
    readonly y: PlotAxis,
    private readonly handlers: PlotHandlers,
    private readonly drawCurves: () => void = () => {},
  ) {
    set(this.picture, { "aria-label": name, dblclick: (event: MouseEvent) => this.doubleClicked(event) });
    this.field.dataset.toX = String(x.to);
    this.picture.append(this.frame, this.curves, this.squares);
    byId(home).replaceChildren(el("div", { class: "plot" }, this.field, this.picture));
    new ResizeObserver(() => this.layout()).observe(byId(home));
  }

  px(value: number): number {
    const share = (value - this.x.from) / (this.x.to - this.x.from);
    return margin.left + share * (this.width - margin.left - margin.right);
  }

  py(value: number): number {
    const share = (value - this.y.from) / (this.y.to - this.y.from);
    return this.height - margin.bottom - share * (this.height - margin.top - margin.bottom);
  }

  show(squares: Square[]): void {
    this.shown = squares;
    while (this.squares.children.length > squares.length) this.squares.lastChild!.remove();
    while (this.squares.children.length < squares.length) this.squares.append(this.newSquare());
    squares.forEach((square, i) => this.place(this.squares.children[i]!, square));
  }

  focusSquare(square: number): void {
    this.squares.children[square]?.querySelector("g")!.focus();
  }

  private layout(): void {
    this.width = this.picture.clientWidth;
    this.height = this.picture.clientHeight;
    if (this.width < 80 || this.height < 80) return;
    const [left, right] = [this.px(this.x.from), this.px(this.x.to)];
    const [bottom, top] = [this.py(this.y.from), this.py(this.y.to)];
    this.field.style.cssText = `left:${left}px;top:${top}px;width:${right - left}px;height:${bottom - top}px`;
    this.frame.replaceChildren(
      svg("rect", { x: left, y: top, width: right - left, height: bottom - top }),
      svg("text", { x: right, y: bottom + 33, class: "end label" }, this.x.label),
      svg("text", { x: left + 8, y: top + 17, class: "start over" }, this.y.label),
    );
    for (const x of this.x.ticks) {
      this.frame.append(svg("path", { d: `M${this.px(x)} ${bottom}v5` }));
      this.frame.append(svg("text", { x: this.px(x), y: bottom + 17 }, String(x)));
    }
    for (const y of this.y.ticks) {
      this.frame.append(svg("path", { d: `M${left} ${this.py(y)}h-5` }));
      this.frame.append(svg("text", { x: left - 8, y: this.py(y) + 4, class: "end" }, String(y)));
    }
    this.drawCurves();
    this.show(this.shown);
  }

  private place(group: Element, square: Square): void {
    const x = clamp(this.px(square.x), margin.left, this.width - margin.right);
    const y = clamp(this.py(square.y), margin.top, this.height - margin.bottom);
    set(group, { transform: `translate(${x} ${y})`, class: square.isSelected ? "square selected" : "square" });
    const said = { "aria-label": square.name, "aria-valuetext": square.text, "aria-valuenow": square.x };
    set(group.querySelector("g")!, said);
    set(group.querySelector(".inside")!, { fill: square.colour });
    const isLeft = x > this.width - 150;
    const labelY = y < margin.top + 16 ? 16 : y > this.height - margin.bottom - 14 ? -12 : 5;
    const label = group.querySelector("text")!;
    set(label, { x: isLeft ? -16 : 16, y: labelY, class: isLeft ? "end" : "start" });
    label.textContent = square.text;
  }

  private newSquare(): SVGGElement {
    const box = (half: number, name: string): SVGRectElement =>
      svg("rect", { x: -half, y: -half, width: 2 * half, height: 2 * half, class: name });
    const handle = svg("g", { tabindex: 0, role: "slider", "aria-valuemin": this.x.from, "aria-valuemax": this.x.to });
    handle.append(box(18, "touch"), box(12, "ring"), box(8, "outside"), box(8, "inside"));
    const group = svg("g", {}, handle, svg("text"));
    const index = (): number => [...this.squares.children].indexOf(group);
    set(handle, {
      pointerdown: (event: PointerEvent) => this.grab(handle, index(), event),
      focus: () => this.handlers.select?.(index()),
      keydown: (event: KeyboardEvent) => this.pressed(index(), event),
      dblclick: (event: MouseEvent) => event.stopPropagation(),
    });
    return group;
  }

  private rounded(x: number, y: number): [number, number] {
    const onAxis = (value: number, { from, to, step }: PlotAxis): number =>
      Number((Math.round(clamp(value, from, to) / step) * step).toFixed(4));
    return [onAxis(x, this.x), onAxis(y, this.y)];
  }

  // What a way of so many pixels to the right and down is worth.
  private moved(x: number, y: number, right: number, down: number): [number, number] {
    const perPixelX = (this.x.to - this.x.from) / (this.width - margin.left - margin.right);
    const perPixelY = (this.y.to - this.y.from) / (this.height - margin.top - margin.bottom);
    return this.rounded(x + right * perPixelX, y - down * perPixelY);
  }

  private doubleClicked(event: MouseEvent): void {
    const box = this.picture.getBoundingClientRect();
    const right = event.clientX - box.left - margin.left;
    const down = event.clientY - box.bottom + margin.bottom;
    this.handlers.add?.(...this.moved(this.x.from, this.y.from, right, down));
  }

  private grab(handle: SVGGElement, index: number, event: PointerEvent): void {
    if (event.button !== 0) return;
    event.preventDefault();
    handle.focus({ preventScroll: true });
    handle.setPointerCapture(event.pointerId);
    const gesture = `drag ${++gestures}`;
    const from = this.shown[index]!;
    const end = new AbortController();
    const move = (at: PointerEvent): void => {
      const [x, y] = this.moved(from.x, from.y, at.clientX - event.clientX, at.clientY - event.clientY);
      const now = this.shown[index];
      if (now && (x !== now.x || y !== now.y)) this.handlers.move(index, x, y, gesture);
    };
    handle.addEventListener("pointermove", move, end);
    for (const name of ["pointerup", "pointercancel"]) handle.addEventListener(name, () => end.abort(), end);
  }

  private pressed(index: number, event: KeyboardEvent): void {
    const way = arrows[event.key];
    const { x, y } = this.shown[index]!;
    if (way) {
      const size = event.shiftKey ? "leap" : "step";
      const to = this.rounded(x + way[0] * this.x[size], y + way[1] * this.y[size]);
      this.handlers.move(index, ...to, `keys ${index}`);
    } else if (event.key === "Enter") this.handlers.add?.(x, y);
    else if (event.key === "Delete" || event.key === "Backspace") this.handlers.remove?.(index);
    else return;
    event.preventDefault();
  }
}
