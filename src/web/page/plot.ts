// Two axes, a field of colours behind them and squares to drag: the plane of peak and angle, and the palette.

import { byId, clamp, el, mix, set, svg } from "./dom";

/** Squares move in steps, and by the arrow keys with Shift in leaps. */
export type PlotAxis = { label: string; from: number; to: number; ticks: number[]; step: number; leap: number };

/** `text` stands beside it, and screen readers say it. */
type Square = { x: number; y: number; colour: string; name: string; text: string; isSelected: boolean };

interface Handlers {
  move(square: number, x: number, y: number, gesture: string): void;
  select?(square: number): void;
  add?(x: number, y: number): void;
  remove?(square: number): void;
  /** The size has changed. */
  layout?(): void;
}

const margin = { left: 44, right: 14, top: 12, bottom: 38 };
const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
const shareOf = (value: number, { from, to }: PlotAxis): number => (value - from) / (to - from);
let gestures = 0;

export class Plot {
  /** Colours; as many pixels as its owner likes, drawn smoothly over the plane. */
  readonly field = el("canvas", { class: "field", "aria-hidden": "true" });
  /** For curves, below the squares. */
  readonly curves = svg("g");
  private readonly frame = svg("g", { class: "frame" });
  private readonly squares = svg("g");
  private readonly picture: SVGSVGElement;
  private shown: Square[] = [];
  private width = 0;
  private height = 0;

  /** @param home  the id of the element that it fills */
  constructor(
    home: string,
    name: string,
    readonly x: PlotAxis,
    readonly y: PlotAxis,
    private readonly handlers: Handlers,
  ) {
    const dblclick = (event: MouseEvent): void => this.doubleClicked(event);
    this.picture = svg("svg", { role: "group", "aria-label": name, dblclick }, this.frame, this.curves, this.squares);
    this.field.dataset.toX = String(x.to);
    byId(home).replaceChildren(el("div", { class: "plot" }, this.field, this.picture));
    new ResizeObserver(() => this.layout()).observe(byId(home));
  }

  readonly px = (x: number): number => mix(margin.left, this.width - margin.right, shareOf(x, this.x));
  readonly py = (y: number): number => mix(this.height - margin.bottom, margin.top, shareOf(y, this.y));

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
    const { left, top } = margin;
    const [right, bottom] = [this.width - margin.right, this.height - margin.bottom];
    const [width, height] = [Math.max(right - left, 1), Math.max(bottom - top, 1)];
    this.field.style.cssText = `left:${left}px;top:${top}px;width:${width}px;height:${height}px`;
    const tick = (line: string, x: number, y: number, text: number, name: string): Node[] =>
      [svg("path", { d: line }), svg("text", { x, y, class: name }, String(text))];
    this.frame.replaceChildren(
      svg("rect", { x: left, y: top, width, height }),
      svg("text", { x: right, y: bottom + 33, class: "end label" }, this.x.label),
      svg("text", { x: left + 8, y: top + 17, class: "start over" }, this.y.label),
      ...this.x.ticks.flatMap((x) => tick(`M${this.px(x)} ${bottom}v5`, this.px(x), bottom + 17, x, "")),
      ...this.y.ticks.flatMap((y) => tick(`M${left} ${this.py(y)}h-5`, left - 8, this.py(y) + 4, y, "end")),
    );
    this.handlers.layout?.();
    this.show(this.shown);
  }

  private place(group: Element, { x: atX, y: atY, colour, name, text, isSelected }: Square): void {
    const x = clamp(this.px(atX), margin.left, this.width - margin.right);
    const y = clamp(this.py(atY), margin.top, this.height - margin.bottom);
    set(group, { transform: `translate(${x} ${y})`, class: isSelected ? "square selected" : "square" });
    set(group.querySelector("g")!, { "aria-label": name, "aria-valuetext": text, "aria-valuenow": atX });
    set(group.querySelector(".inside")!, { fill: colour });
    const isLeft = x > this.width - 150;
    const labelY = y < margin.top + 16 ? 16 : y > this.height - margin.bottom - 14 ? -12 : 5;
    const placed = { x: isLeft ? -16 : 16, y: labelY, class: isLeft ? "end" : "start" };
    set(group.querySelector("text")!, placed).textContent = text;
  }

  private newSquare(): SVGGElement {
    const boxes = Object.entries({ touch: 18, ring: 12, outside: 8, inside: 8 }).map(([name, half]) =>
      svg("rect", { x: -half, y: -half, width: 2 * half, height: 2 * half, class: name }),
    );
    const range = { "aria-valuemin": this.x.from, "aria-valuemax": this.x.to };
    const handle = svg("g", { tabindex: 0, role: "slider", ...range }, ...boxes);
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
    const at = (value: number, { from, to, step }: PlotAxis): number =>
      Number((Math.round(clamp(value, from, to) / step) * step).toFixed(4));
    return [at(x, this.x), at(y, this.y)];
  }

  // Numbers of the axes, so many pixels to the right and down of others.
  private moved(x: number, y: number, right: number, down: number): [number, number] {
    const perPixelX = (this.x.to - this.x.from) / (this.px(this.x.to) - this.px(this.x.from));
    const perPixelY = (this.y.to - this.y.from) / (this.py(this.y.to) - this.py(this.y.from));
    return this.rounded(x + right * perPixelX, y + down * perPixelY);
  }

  private doubleClicked(event: MouseEvent): void {
    const box = this.picture.getBoundingClientRect();
    const [right, down] = [event.clientX - box.left - margin.left, event.clientY - box.bottom + margin.bottom];
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
    const way = (ways as Record<string, number[]>)[event.key];
    const { x, y } = this.shown[index]!;
    const size = event.shiftKey ? "leap" : "step";
    if (way) {
      const to = this.rounded(x + way[0]! * this.x[size], y + way[1]! * this.y[size]);
      this.handlers.move(index, ...to, `keys ${index}`);
    } else if (event.key === "Enter") this.handlers.add?.(x, y);
    else if (event.key === "Delete" || event.key === "Backspace") this.handlers.remove?.(index);
    else return;
    event.preventDefault();
  }
}
