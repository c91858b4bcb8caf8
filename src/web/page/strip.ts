// The LUT over its angle, the bound with what was reached, and what other bounds cost.

import type { Axis, BakedLut, CostPoint } from "./api";
import { byId, clamp, el, mix, NumberControl, paint, readableBytes, readableSeconds, short, svg } from "./dom";
import type { Page } from "./page";

const bounds = [2, 1, 0.5, 0.2, 0.1, 0.05, 0.02];
const degrees = Math.PI / 180;

/** The texture coordinate, 0 to 1, of a place across a strip: even in degrees for angles, even in itself for others. */
function coordinate(axis: Axis, share: number): number {
  const theta = 90 * share;
  const values: Record<string, number> = {
    sqrt_cos_theta: Math.sqrt(Math.max(0, Math.cos(theta * degrees))),
    cos_theta: Math.max(0, Math.cos(theta * degrees)),
    theta_deg: theta,
  };
  const value = values[axis.name] ?? mix(axis.from, axis.to, share);
  return clamp((value - axis.from) / (axis.to - axis.from), 0, 1);
}

/** The colour between the texels, in the LUT's own space. */
function fetched(lut: BakedLut, x: number, y: number, component: number): number {
  const place = x * (lut.width - 1);
  const left = Math.min(Math.floor(place), Math.max(0, lut.width - 2));
  const right = Math.min(left + 1, lut.width - 1);
  const row = Math.round(y * (lut.height - 1)) * lut.width;
  return mix(lut.texels[3 * (row + left) + component]!, lut.texels[3 * (row + right) + component]!, place - left);
}

/** Draws a LUT; even degrees from left to right, the smallest y at the bottom.
 *  @returns the columns that have a negative component, and the factor by which it was brightened */
export function drawStrip(canvas: HTMLCanvasElement, lut: BakedLut, width: number): { isNegative: boolean[]; gain: number } {
  const colours = new Float32Array(width * lut.height * 3);
  const isNegative = new Array<boolean>(width).fill(false);
  let brightest = 0;
  for (let at = 0; at < width * lut.height; ++at) {
    const column = at % width;
    const y = lut.height > 1 ? 1 - Math.floor(at / width) / (lut.height - 1) : 0;
    const x = coordinate(lut.x, column / (width - 1));
    const raw = [0, 1, 2].map((component) => fetched(lut, x, y, component));
    if (Math.min(...raw) < -1e-4) isNegative[column] = true;
    for (let i = 0; i < 3; ++i) {
      const value = [0, 1, 2].reduce((sum, j) => sum + lut.toRec709[3 * i + j]! * raw[j]!, 0);
      colours[3 * at + i] = value;
      if (!lut.x.isAngle || column < width / 1.5) brightest = Math.max(brightest, value);
    }
  }
  const gain = brightest > 1 || brightest < 0.15 ? 0.95 / Math.max(brightest, 1e-4) : 1;
  const rgb = [0, 0, 0];
  paint(canvas, width, lut.height, (x, y) => {
    for (let i = 0; i < 3; ++i) rgb[i] = gain * colours[3 * (y * width + x) + i]!;
    return rgb;
  });
  return { isNegative, gain };
}

export class StripPanel {
  private readonly canvas = byId<HTMLCanvasElement>("strip-canvas");
  private readonly bound: NumberControl;
  private readonly chooser = byId<HTMLSelectElement>("lut-select");
  private points: CostPoint[] = [];
  private costKey = "";
  private costTimer = 0;

  constructor(private readonly page: Page) {
    const spec = { label: "Error bound ΔE00", from: 0.01, to: 2, step: 0.01, isLogarithmic: true };
    this.bound = new NumberControl(spec, (value, gesture) => this.setBound(value, gesture));
    byId("bound").append(this.bound.element);
    this.chooser.addEventListener("change", () => page.selectLut(this.chooser.value));
    new ResizeObserver(() => this.show()).observe(this.canvas);
  }

  show(): void {
    const { baked: lut, doc, isCoarse } = this.page;
    this.showChooser();
    if (!lut) return;
    const width = Math.round(clamp(this.canvas.clientWidth, 64, lut.height > 1 ? 256 : 1024));
    const { isNegative, gain } = drawStrip(this.canvas, lut, width);
    const stops = Math.log2(gain);
    byId("negative").replaceChildren(...this.negativeRegions(isNegative));
    byId("strip-axis").replaceChildren(...this.axis(lut), ...this.picks(lut));
    this.bound.show(this.page.lut!.maxDe00, doc.value("accuracy.max_de00") !== undefined);
    const seconds = lut.seconds.deciding + lut.seconds.computing + lut.seconds.measuring;
    const reached = lut.reached === undefined ? "not measured" : short(lut.reached, 2);
    const facts: [string, string][] = [
      ["reached ΔE00", isCoarse ? "coarse …" : reached],
      ["size", `${lut.width} × ${lut.height} ${lut.format}`],
      ["file", readableBytes(lut.bytes)],
      ["time", readableSeconds(seconds)],
      ["space", lut.space],
    ];
    if (Math.abs(stops) > 0.05) facts.push(["shown at", `${stops > 0 ? "+" : ""}${short(stops, 2)} EV`]);
    byId("facts").replaceChildren(
      ...facts.map(([name, value]) => el("div", {}, el("dt", {}, name), el("dd", {}, value))),
    );
    this.drawCost();
    this.planCost();
  }

  private showChooser(): void {
    const names = this.page.doc.scene.luts.map((lut) => lut.name);
    if (names.join() !== [...this.chooser.options].map((option) => option.value).join()) {
      this.chooser.replaceChildren(...names.map((name) => el("option", { value: name }, name)));
    }
    this.chooser.value = this.page.lut?.name ?? "";
  }

  // A LUT may have a bound of its own.
  private setBound(value: number, gesture: string): void {
    const own = `lut.${this.page.lut?.entry}.max_de00`;
    const path = this.page.doc.value(own) ? own : "accuracy.max_de00";
    this.page.doc.set({ [path]: value }, gesture);
  }

  private negativeRegions(isNegative: boolean[]): Node[] {
    const regions: Node[] = [];
    for (let begin = 0; begin < isNegative.length; ++begin) {
      if (!isNegative[begin]) continue;
      let end = begin;
      while (end < isNegative.length && isNegative[end]) ++end;
      const [left, width] = [begin, end - begin].map((column) => `${(100 * column) / isNegative.length}%`);
      const title = `Outside ${this.page.baked!.space}: a component is negative`;
      regions.push(el("span", { style: `left:${left};width:${width}`, title }));
      begin = end;
    }
    return regions;
  }

  private axis(lut: BakedLut): Node[] {
    const isAngle = lut.x.isAngle && lut.x.name !== "grating_u" && lut.x.name !== "cos_scatter";
    return [0, 1, 2, 3, 4, 5, 6].map((sixth) => {
      const name = isAngle ? `${15 * sixth}°` : short(mix(lut.x.from, lut.x.to, sixth / 6), 2);
      return el("span", { class: "tick", style: `left:${(100 * sixth) / 6}%` }, name);
    });
  }

  private picks(lut: BakedLut): Node[] {
    if (!lut.x.isAngle) return [];
    return (this.page.material?.picks ?? []).map((pick, i) =>
      el("span", {
        class: i === this.page.pick ? "pick selected" : "pick",
        style: `left:${pick.angleDeg / 0.9}%`,
        title: `Pick ${i + 1}`,
      }),
    );
  }

  // The curve does not depend on the bound of the scene. It waits until the scene has been still for a while.
  private planCost(): void {
    const { doc, lut } = this.page;
    const key = `${lut!.name}\n${doc.text.replace(/max_de00\s*=\s*\S+/g, "")}`;
    if (key === this.costKey) return;
    this.costKey = key;
    this.points = [];
    this.drawCost();
    clearTimeout(this.costTimer);
    this.costTimer = window.setTimeout(() => void this.measureCost(key), 800);
  }

  private async measureCost(key: string): Promise<void> {
    for (const bound of bounds) {
      const point = await this.page.inSpareTime(() => this.page.inWorker((worker, lut) => worker.cost(lut, bound)));
      if (key !== this.costKey) return;
      if (!point) {
        this.costKey = "";
        return;
      }
      if (point.failure === undefined) this.points.push(point);
      this.drawCost();
    }
  }

  private drawCost(): void {
    const seconds = (point: { seconds: CostPoint["seconds"] }): number =>
      point.seconds.deciding + point.seconds.computing + point.seconds.measuring;
    const { baked, isCoarse } = this.page;
    const charts = [
      { name: "time", of: seconds, text: readableSeconds },
      { name: "bytes", of: (point: { bytes: number }) => point.bytes, text: readableBytes },
    ].map(({ name, of, text }) => {
      const points = this.points.map((point) => ({ bound: point.maxDe00, value: of(point) }));
      const present = baked && !isCoarse ? { bound: baked.maxDe00, value: of(baked) } : undefined;
      return this.chart(name, points, present, text);
    });
    byId("cost").replaceChildren(...charts);
  }

  private chart(
    name: string,
    points: { bound: number; value: number }[],
    present: { bound: number; value: number } | undefined,
    text: (value: number) => string,
  ): SVGElement {
    const values = [...points, ...(present ? [present] : [])].map((point) => Math.max(point.value, 1e-9));
    const [low, high] = [Math.min(...values) / 1.3, Math.max(...values) * 1.3];
    const x = (bound: number): number => 10 + 130 * (Math.log(2 / clamp(bound, 0.01, 2)) / Math.log(200));
    const y = (value: number): number => 66 - 40 * (Math.log(Math.max(value, 1e-9) / low) / Math.log(high / low));
    const chart = svg("svg", { viewBox: "0 0 150 84", role: "img", class: "chart" });
    const said = points.map((point) => `${point.bound}: ${text(point.value)}`).join("; ");
    chart.setAttribute("aria-label", `${name} against the bound ΔE00. ${said}`);
    chart.append(svg("text", { x: 10, y: 12 }, name), svg("path", { class: "grid", d: "M10 70H140" }));
    for (const bound of [2, 0.2, 0.02]) chart.append(svg("text", { x: x(bound), y: 81, class: "mid" }, String(bound)));
    const line = points.map((point) => `${x(point.bound)} ${y(point.value)}`).join("L");
    if (line !== "") chart.append(svg("path", { class: "line", d: `M${line}` }));
    for (const point of points) {
      const dot = svg("circle", { cx: x(point.bound), cy: y(point.value), r: 2 });
      dot.append(svg("title", {}, `ΔE00 ${point.bound}: ${text(point.value)}`));
      chart.append(dot);
    }
    if (present) {
      chart.append(svg("circle", { class: "present", cx: x(present.bound), cy: y(present.value), r: 4.5 }));
      chart.append(svg("text", { x: 140, y: 12, class: "end strong" }, text(present.value)));
    }
    return chart;
  }
}
