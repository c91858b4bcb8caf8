// Elements by one call each, a slider with its number, and the colours of a screen.

type Attribute = string | number | boolean | undefined | ((event: never) => void);
type Attributes = Record<string, Attribute>;

function furnish(element: Element, attributes: Attributes, children: (Node | string)[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value as EventListener);
    else if (value !== undefined && value !== false) element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children);
}

/** An HTML element. A function among the attributes listens to the event of that name. */
export function el<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  furnish(element, attributes, children);
  return element;
}

export function svg<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  furnish(element, attributes, children);
  return element;
}

/** The element with this id, which index.html has. */
export function byId<Kind extends HTMLElement = HTMLElement>(id: string): Kind {
  return document.getElementById(id) as Kind;
}

export const clamp = (value: number, low: number, high: number): number => Math.min(Math.max(value, low), high);
export const mix = (a: number, b: number, share: number): number => a + (b - a) * share;

/** A number with so many digits that count, without zeros at its end. */
export const short = (value: number, digits = 3): string => String(Number(value.toPrecision(digits)));

export function readableBytes(bytes: number): string {
  if (bytes < 1000) return `${bytes} B`;
  return bytes < 1e6 ? `${short(bytes / 1e3)} kB` : `${short(bytes / 1e6)} MB`;
}

export function readableSeconds(seconds: number): string {
  if (seconds < 1e-3) return `${short(seconds * 1e6, 2)} µs`;
  return seconds < 1 ? `${short(seconds * 1e3, 2)} ms` : `${short(seconds, 2)} s`;
}

// IEC 61966-2-1: from linear light, 0 to 1, to a byte of sRGB.
function srgbByte(linear: number): number {
  const value = clamp(linear, 0, 1);
  return Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055));
}
const tableSize = 8192;
const srgbBytes = Uint8Array.from({ length: tableSize + 1 }, (_, i) => srgbByte(i / tableSize));

/** Linear Rec.709 as "#rrggbb", clipped. */
export function hex(rgb: ArrayLike<number>): string {
  return `#${Array.from(rgb, (value) => srgbByte(value).toString(16).padStart(2, "0")).join("")}`;
}

/** Writes pixels as nacre draws its pictures: what sRGB lacks is moved into it as src/nacre/swatch/swatch_gamut.h says.
 *  @param at  gives linear Rec.709 of a column and a row, the first row on top, in an array that it may use again */
export function paint(canvas: HTMLCanvasElement, width: number, height: number, at: (x: number, y: number) => ArrayLike<number>): void {
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d")!;
  const image = context.createImageData(width, height);
  for (let i = 0; i < width * height; ++i) {
    const rgb = at(i % width, Math.floor(i / width));
    const most = Math.max(rgb[0]!, rgb[1]!, rgb[2]!);
    for (let component = 0; component < 3; ++component) {
      const beyond = (1 - rgb[component]! / most - 0.9) / 0.1;
      const value = beyond > 0 && most > 0 ? most * (0.1 - (0.1 * beyond) / (1 + beyond ** 1.2) ** (1 / 1.2)) : rgb[component]!;
      image.data[4 * i + component] = srgbBytes[Math.round(clamp(value, 0, 1) * tableSize)]!;
    }
    image.data[4 * i + 3] = 255;
  }
  context.putImageData(image, 0, 0);
}

export interface NumberSpec {
  label: string;
  unit?: string;
  from: number;
  to: number;
  step: number;
  /** Equal ratios take equal ways of the slider. `from` is above 0 then. */
  isLogarithmic?: boolean;
}

const steps = 1000;
let gestures = 0;

/** A slider and a field for the same number. */
export class NumberControl {
  readonly element: HTMLElement;
  private readonly slider: HTMLInputElement;
  private readonly field: HTMLInputElement;
  private gesture = ++gestures;
  private isTyping = false;

  /** @param change  the new number; edits with the same gesture are one step of undo */
  constructor(
    private readonly spec: NumberSpec,
    private readonly change: (value: number, gesture: string) => void,
  ) {
    const { label, unit, from, to, step } = spec;
    const range = spec.isLogarithmic ? { min: 0, max: steps, step: 1 } : { min: from, max: to, step };
    this.slider = el("input", { type: "range", ...range, "aria-label": label, input: () => this.slid() });
    this.slider.addEventListener("change", () => (this.gesture = ++gestures));
    this.field = el("input", { type: "number", min: from, step: spec.isLogarithmic ? "any" : step });
    this.field.setAttribute("aria-label", unit ? `${label} in ${unit}` : label);
    this.field.addEventListener("input", () => (this.isTyping = true));
    this.field.addEventListener("change", () => this.typed());
    this.element = el("div", { class: "number" }, el("span", { class: "name" }, label), this.slider, this.field);
    this.element.append(el("span", { class: "unit" }, unit ?? ""));
  }

  /** @param isGiven  false: the number is a default that the scene does not say */
  show(value: number | undefined, isGiven = true): void {
    this.element.classList.toggle("default", !isGiven);
    if (value === undefined) return;
    const { from, to, unit } = this.spec;
    const share = this.spec.isLogarithmic ? (steps * Math.log(value / from)) / Math.log(to / from) : value;
    this.slider.value = String(share);
    const low = Number(this.slider.min);
    const filled = (100 * (Number(this.slider.value) - low)) / (Number(this.slider.max) - low);
    this.slider.style.setProperty("--filled", `${filled}%`);
    this.slider.setAttribute("aria-valuetext", `${short(value, 4)} ${unit ?? ""}`);
    if (!this.isTyping) this.field.value = short(value, 5);
  }

  private slid(): void {
    const { from, to } = this.spec;
    const at = Number(this.slider.value);
    const value = this.spec.isLogarithmic ? Number(short(from * (to / from) ** (at / steps), 2)) : at;
    this.change(value, `slider ${this.gesture}`);
  }

  private typed(): void {
    const value = Number(this.field.value);
    this.isTyping = false;
    if (this.field.value !== "" && Number.isFinite(value)) this.change(value, `field ${++gestures}`);
  }
}
