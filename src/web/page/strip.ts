// The LUT over its angle, the bound with what was reached, and what other bounds cost.

import type { Axis, BakedLut, CostPoint } from "./api";
import { byId, clamp, el, mix, NumberControl, paint, readableBytes, readableSeconds, short, svg } from "./dom";
import type { NacrePage } from "./main";

const bounds = [2, 1, 0.5, 0.2, 0.1, 0.05, 0.02];
const isEvenInDegrees = (axis: Axis): boolean => ["sqrt_cos_theta", "cos_theta", "theta_deg"].includes(axis.name);

/** The texture coordinate, 0 to 1, of a place across a strip: even in degrees for angles, even in itself for others. */
function coordinate(axis: Axis, share: number): number {
  const cosTheta = Math.max(0, Math.cos((share * Math.PI) / 2));
  const angles = { sqrt_cos_theta: Math.sqrt(cosTheta), cos_theta: cosTheta, theta_deg: 90 * share };
  const value = (angles as Record<string, number>)[axis.name] ?? mix(axis.from, axis.to, share);
  return clamp((value - axis.from) / (axis.to - axis.from), 0, 1);
}

/** Paints a LUT; even degrees from left to right, the smallest y at the bottom.
 *  @returns the columns that have a negative component, and the factor by which it was brightened */
export function paintStrip(canvas: HTMLCanvasElement, lut: BakedLut, width: number): [boolean[], number] {
  const columns = Array.from({ length: width }, (_, x) => coordinate(lut.x, x / (width - 1)) * (lut.width - 1));
  const isNegative = columns.map(() => false);
  const fetch = (x: number, y: number, rgb: number[]): void => {
    const left = Math.floor(columns[x]!);
    const at = 3 * ((lut.height - 1 - y) * lut.width + left);
    const next = at + (left < lut.width - 1 ? 3 : 0);
    const raw = [0, 1, 2].map((i) => mix(lut.texels[at + i]!, lut.texels[next + i]!, columns[x]! - left));
    if (raw.some((component) => component < -1e-4)) isNegative[x] = true;
    for (let i = 0; i < 3; ++i) rgb[i] = raw.reduce((sum, value, j) => sum + lut.toRec709[3 * i + j]! * value, 0);
  };
  // Towards grazing angles most surfaces are white.
  const [rgb, end] = [[0, 0, 0], isEvenInDegrees(lut.x) ? width / 1.5 : width];
  let brightest = 1e-4;
  for (let i = 0; i < end * lut.height; i += 4) {
    fetch(Math.floor(i / lut.height), i % lut.height, rgb);
    brightest = Math.max(brightest, ...rgb);
  }
  const gain = brightest > 1 || brightest < 0.15 ? 0.95 / brightest : 1;
  paint(canvas, width, lut.height, (x, y, written) => {
    fetch(x, y, written);
    for (let i = 0; i < 3; ++i) written[i]! *= gain;
  });
  return [isNegative, gain];
}

const allSeconds = ({ seconds }: { seconds: CostPoint["seconds"] }): number =>
  seconds.deciding + seconds.computing + seconds.measuring;

/** A number against the bound, both in equal ratios. The one of the scene is marked. */
function chart(name: string, points: [number, number][], present: [number, number], text: (n: number) => string): Node {
  const values = [...points, present].map(([, value]) => Math.max(value, 1e-6));
  const [low, high] = [Math.min(...values) / 1.3, Math.max(...values) * 1.3];
  const x = (bound: number): number => 10 + 130 * (Math.log(2 / clamp(bound, 0.01, 2)) / Math.log(200));
  const y = (value: number): number => 66 - 40 * (Math.log(Math.max(value, 1e-6) / low) / Math.log(high / low));
  const said = points.map(([bound, value]) => `${bound}: ${text(value)}`).join("; ");
  const label = `${name} against the bound ΔE00. ${said}`;
  const line = points.map(([bound, value]) => `${x(bound)} ${y(value)}`).join("L");
  return svg(
    ...(["svg", { viewBox: "0 0 150 84", role: "img", class: "chart", "aria-label": label }] as const),
    ...[svg("text", { x: 10, y: 12 }, name), svg("path", { class: "grid", d: "M10 70H140" })],
    ...[2, 0.2, 0.02].map((bound) => svg("text", { x: x(bound), y: 81, class: "mid" }, String(bound))),
    svg("path", { class: "line", d: line === "" ? "" : `M${line}` }),
    ...points.map(([bound, value]) => svg("circle", { cx: x(bound), cy: y(value), r: 2 })),
    svg("circle", { class: "present", cx: x(present[0]), cy: y(present[1]), r: 4.5 }),
    svg("text", { x: 140, y: 12, class: "end strong" }, text(present[1])),
  );
}

export class StripPanel {
  private readonly canvas = byId<HTMLCanvasElement>("strip-canvas");
  private readonly chooser = byId<HTMLSelectElement>("lut-select");
  private readonly bound: NumberControl;
  private width = 512;
  private points: CostPoint[] = [];
  private costKey = "";
  private costTimer = 0;

  constructor(private readonly page: NacrePage) {
    const spec = { label: "Error bound ΔE00", from: 0.01, to: 2, step: 0.01, isLogarithmic: true };
    this.bound = new NumberControl(spec, (value, gesture) => {
      const own = `lut.${page.lut?.entry}.max_de00`;
      page.doc.set({ [page.doc.has(own) ? own : "accuracy.max_de00"]: value }, gesture);
    });
    byId("bound").append(this.bound.element);
    this.chooser.addEventListener("change", () => page.selectLut(this.chooser.value));
    const resized = (): void => void (this.width = clamp(this.canvas.clientWidth, 64, 1024));
    new ResizeObserver(() => [resized(), this.show()]).observe(this.canvas);
  }

  show(): void {
    const { baked: lut, doc, lut: summary } = this.page;
    const names = doc.scene.luts.map(({ name }) => name);
    if (names.join() !== [...this.chooser.options].map(({ value }) => value).join()) {
      this.chooser.replaceChildren(...names.map((value) => el("option", { value }, value)));
    }
    this.chooser.value = summary?.name ?? "";
    if (!lut || !summary) return;
    const [isNegative, gain] = paintStrip(this.canvas, lut, lut.height > 1 ? 256 : this.width);
    byId("negative").replaceChildren(...this.negativeRegions(isNegative));
    byId("strip-axis").replaceChildren(...this.marks(lut));
    this.bound.show(summary.maxDe00, doc.has("accuracy.max_de00"));
    this.showFacts(lut, Math.log2(gain));
    this.planCost();
    this.drawCost();
  }

  private showFacts(lut: BakedLut, stops: number): void {
    const facts: Record<string, string> = {
      "reached ΔE00": this.page.isCoarse ? "coarse …" : lut.reached === undefined ? "–" : short(lut.reached, 2),
      size: `${lut.width} × ${lut.height} ${lut.format}`,
      file: readableBytes(lut.bytes),
      time: readableSeconds(allSeconds(lut)),
      space: lut.space,
      ...(stops === 0 ? {} : { "shown at": `${stops > 0 ? "+" : ""}${short(stops, 2)} EV` }),
    };
    const rows = Object.entries(facts).map(([name, value]) => el("div", {}, el("dt", {}, name), el("dd", {}, value)));
    byId("facts").replaceChildren(...rows);
  }

  private negativeRegions(isNegative: boolean[]): Node[] {
    const title = `Outside ${this.page.baked!.space}: a component is negative`;
    const runs = isNegative.map((is) => (is ? "n" : " ")).join("").matchAll(/n+/g);
    return [...runs].map((run) => {
      const [left, width] = [run.index, run[0].length].map((columns) => `${(100 * columns) / isNegative.length}%`);
      return el("span", { style: `left:${left};width:${width}`, title });
    });
  }

  // The ticks of the axis below the strip, and the picks above it.
  private marks({ x }: BakedLut): Node[] {
    const ticks = [0, 1, 2, 3, 4, 5, 6].map((sixth) => {
      const name = isEvenInDegrees(x) ? `${15 * sixth}°` : short(mix(x.from, x.to, sixth / 6), 2);
      return el("span", { class: "tick", style: `left:${(100 * sixth) / 6}%` }, name);
    });
    const picks = isEvenInDegrees(x) ? (this.page.material?.picks ?? []) : [];
    const squares = picks.map(({ angleDeg }, i) => {
      const name = i === this.page.pick ? "pick selected" : "pick";
      return el("span", { class: name, style: `left:${angleDeg / 0.9}%`, title: `Pick ${i + 1}` });
    });
    return [...ticks, ...squares];
  }

  // The curve does not depend on the bound of the scene. It waits until the scene has been still for a while.
  private planCost(): void {
    const key = `${this.page.lut!.name}\n${this.page.doc.text.replace(/max_de00\s*=\s*\S+/g, "")}`;
    if (key === this.costKey) return;
    this.costKey = key;
    this.points = [];
    clearTimeout(this.costTimer);
    this.costTimer = window.setTimeout(() => void this.measureCost(key), 800);
  }

  private async measureCost(key: string): Promise<void> {
    for (const bound of bounds) {
      const point = await this.page.inSpareTime((worker, lut) => worker.cost(lut, bound));
      if (key !== this.costKey) return;
      if (!point) this.costKey = "";
      else if (point.failure === undefined) this.points.push(point);
      this.drawCost();
    }
  }

  private drawCost(): void {
    const { baked, isCoarse } = this.page;
    if (!baked || isCoarse) return;
    const draw = (name: string, of: (point: CostPoint | BakedLut) => number, text: (n: number) => string): Node =>
      chart(name, this.points.map((point) => [point.maxDe00, of(point)]), [baked.maxDe00, of(baked)], text);
    const bytes = draw("bytes", (point) => point.bytes, readableBytes);
    byId("cost").replaceChildren(draw("time", allSeconds, readableSeconds), bytes);
  }
}
