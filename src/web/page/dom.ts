// Elements by one call each, pixels as nacre draws its pictures, and a slider with its number.

type Attributes = Record<string, string | number | boolean | undefined | ((event: never) => void)>;
type Children = (Node | string)[];

/** Sets attributes; functions listen to the event of that name, false and undefined remove. */
export function set<Kind extends Element>(element: Kind, attributes: Attributes, ...children: Children): Kind {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value as EventListener);
    else if (value === undefined || value === false) element.removeAttribute(name);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children);
  return element;
}

type Html = keyof HTMLElementTagNameMap;
type Svg = keyof SVGElementTagNameMap;
export const el = <Tag extends Html>(tag: Tag, attributes: Attributes = {}, ...children: Children) =>
  set(document.createElement(tag), attributes, ...children);
export const svg = <Tag extends Svg>(tag: Tag, attributes: Attributes = {}, ...children: Children) =>
  set(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, ...children);
/** The element with this id, which index.html has. */
export const byId = <Kind extends HTMLElement = HTMLElement>(id: string): Kind => document.getElementById(id) as Kind;

export const clamp = (value: number, low: number, high: number): number => Math.min(Math.max(value, low), high);
export const mix = (a: number, b: number, share: number): number => a + (b - a) * share;
/** A number with so many digits that count, without zeros at its end. */
export const short = (value: number, digits = 3): string => String(Number(value.toPrecision(digits)));
export const readableBytes = (n: number): string => (n < 1e6 ? `${short(n / 1e3)} kB` : `${short(n / 1e6)} MB`);
export const readableSeconds = (n: number): string => (n < 1 ? `${short(n * 1e3, 2)} ms` : `${short(n, 2)} s`);

// IEC 61966-2-1: from linear light to a byte of sRGB.
function srgbByte(linear: number): number {
  const value = clamp(linear, 0, 1);
  return Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055));
}
const tableSize = 8192;
const srgbBytes = Uint8Array.from({ length: tableSize + 1 }, (_, i) => srgbByte(i / tableSize));

/** Linear Rec.709 as "#rrggbb", clipped. */
export const hex = (rgb: number[]): string =>
  `#${rgb.map((value) => srgbByte(value).toString(16).padStart(2, "0")).join("")}`;

// As src/nacre/swatch/swatch_gamut.cpp: what sRGB lacks moves into it, so that its edge shows no flat bands.
function fitted(value: number, most: number): number {
  const beyond = (0.1 - value / most) / 0.1;
  return beyond > 0 && most > 0 ? most * (0.1 - (0.1 * beyond) / (1 + beyond ** 1.2) ** (1 / 1.2)) : value;
}

type Write = (x: number, y: number, rgb: number[]) => void;

/** Paints a canvas. `write` puts linear Rec.709 of a column and a row, the first row on top, into its last argument. */
export function paint(canvas: HTMLCanvasElement, width: number, height: number, write: Write): void {
  Object.assign(canvas, { width, height });
  const context = canvas.getContext("2d")!;
  const image = context.createImageData(width, height);
  const rgb = [0, 0, 0];
  for (let i = 0; i < width * height; ++i) {
    write(i % width, Math.floor(i / width), rgb);
    const most = Math.max(rgb[0]!, rgb[1]!, rgb[2]!);
    for (let component = 0; component < 3; ++component) {
      const share = clamp(fitted(rgb[component]!, most), 0, 1);
      image.data[4 * i + component] = srgbBytes[Math.round(share * tableSize)]!;
    }
    image.data[4 * i + 3] = 255;
  }
  context.putImageData(image, 0, 0);
}

/** Logarithmic: equal ratios take equal ways of the slider; `from` is above 0 then. */
type Range = { from: number; to: number; step: number };
export type NumberSpec = Range & { label: string; unit?: string; isLogarithmic?: boolean };

const sliderSteps = 1000;
let gestures = 0;

/** A slider and a field for the same number; edits with the same gesture are one step of undo. */
export class NumberControl {
  readonly element: HTMLElement;
  private readonly slider: HTMLInputElement;
  private readonly field = el("input", { type: "number", step: "any" });
  private gesture = ++gestures;
  private isTyping = false;

  constructor(private readonly spec: NumberSpec, private readonly change: (value: number, gesture: string) => void) {
    const { label, unit = "", from, to, step, isLogarithmic } = spec;
    const range = isLogarithmic ? { min: 0, max: sliderSteps, step: 1 } : { min: from, max: to, step };
    const rest = (): number => (this.gesture = ++gestures);
    this.slider = el("input", { type: "range", ...range, "aria-label": label, input: () => this.slid(), change: rest });
    const input = (): boolean => (this.isTyping = true);
    set(this.field, { "aria-label": `${label} ${unit}`, input, change: () => this.typed() });
    const [name, end] = [el("span", { class: "name" }, label), el("span", { class: "unit" }, unit)];
    this.element = el("div", { class: "number" }, name, this.slider, this.field, end);
  }

  /** @param isGiven  false: the number is a default that the scene does not say */
  show(value: number | undefined, isGiven = true): void {
    this.element.classList.toggle("default", !isGiven);
    if (value === undefined || Number.isNaN(value)) return;
    const { from, to, unit, isLogarithmic } = this.spec;
    const share = isLogarithmic ? Math.log(value / from) / Math.log(to / from) : (value - from) / (to - from);
    this.slider.value = String(isLogarithmic ? sliderSteps * share : value);
    this.slider.style.setProperty("--filled", `${100 * clamp(share, 0, 1)}%`);
    this.slider.setAttribute("aria-valuetext", `${short(value, 4)} ${unit ?? ""}`);
    if (!this.isTyping) this.field.value = short(value, 4);
  }

  private slid(): void {
    const { from, to, isLogarithmic } = this.spec;
    const at = Number(this.slider.value);
    const value = isLogarithmic ? Number(short(from * (to / from) ** (at / sliderSteps), 2)) : at;
    this.change(value, `slider ${this.gesture}`);
  }

  private typed(): void {
    this.isTyping = false;
    if (this.field.value !== "") this.change(Number(this.field.value), `field ${++gestures}`);
  }
}
