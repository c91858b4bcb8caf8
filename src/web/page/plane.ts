// The plane of peak wavelength and angle, with one square for each pick, as in the paper's Figure 10.

import type { Engine, Material } from "./api";
import { materialPath } from "./document";
import { byId, clamp, el, hex, mix, NumberControl, paint, short, svg } from "./dom";
import type { NacrePage } from "./main";
import { Plot } from "./plot";

type Band = NonNullable<Material["curve"]>[number];

const peaks = { from: 360, to: 830, step: 5 };
const widths = { to: 400, step: 20 };
const rows = 46;

/** The numbers of a band as the scene names them. Floor and flatness are left out where they are 0. */
function bandOf({ peakNm, widthNm, height, floor, flatness }: Band): Record<string, number> {
  const all = { peak_nm: peakNm, width_nm: widthNm, height, floor, flatness };
  const given = Object.entries(all).filter(([key, value]) => !key.startsWith("fl") || value !== 0);
  return Object.fromEntries(given.map(([key, value]) => [key, Number(value.toPrecision(5))]));
}

/** Changes the band of a pick. One that is given as a colour becomes the band that nacre made of it. */
export function changeBand(page: NacrePage, index: number, changes: Record<string, number>, gesture: string): void {
  const path = `${materialPath(page.material!)}.picks[${index}]`;
  const colour = ["colour", "color"].find((key) => page.doc.has(`${path}.${key}`));
  if (colour === undefined || Object.keys(changes).join() === "angle_deg") page.doc.set(changes, gesture, path);
  else page.doc.exchange(path, { ...bandOf(page.material!.picks![index]!), ...changes }, [colour, "space"], gesture);
}

/** Colours of bands of height 1 by peak and width. A colour is linear in the height, so one table serves all of a
 *  plane; it depends on the light of the scene and on the flatness. */
class BandTable {
  columns: Float32Array[] = [];
  private key = "";

  update(engine: Engine, light: string, flatness: number): void {
    const key = `${light} ${flatness}`;
    if (key === this.key) return;
    this.key = key;
    const count = widths.to / widths.step + 1;
    this.columns = Array.from({ length: (peaks.to - peaks.from) / peaks.step + 1 }, (_, i) => {
      const band = { peakNm: peaks.from + i * peaks.step, widthNm: 0, height: 1, floor: 0, flatness };
      return engine.paletteField({ ...band, angleDeg: 0, rgb: [0, 0, 0] }, widths.to, count, 2).slice(count * 3);
    });
  }

  at(column: number, widthNm: number, component: number): number {
    const place = clamp(widthNm, 0, widths.to - 1) / widths.step;
    const at = 3 * Math.floor(place) + component;
    return mix(this.columns[column]![at]!, this.columns[column]![at + 3]!, place % 1);
  }
}

export class PlanePanel {
  private readonly table = new BandTable();
  private readonly plot: Plot;
  private readonly lines = ["band", "curve below", "curve", "height-end"].map((name) => svg("path", { class: name }));
  private readonly shape: NumberControl;
  private readonly remover = el("button", { click: () => this.remove(this.page.pick) }, "Delete");

  constructor(private readonly page: NacrePage) {
    const ticks = [400, 450, 500, 550, 600, 650, 700, 750, 800];
    const x = { label: "peak wavelength (nm)", ...peaks, ticks, step: 1, leap: 10 };
    const y = { label: "angle (°)", from: 0, to: 90, ticks: [0, 15, 30, 45, 60, 75, 90], step: 1, leap: 10 };
    this.plot = new Plot("plane", "Picks: peak wavelength and angle", x, y, {
      move: (pick, peakNm, angleDeg, gesture) => this.move(pick, peakNm, angleDeg, gesture),
      select: (pick) => page.selectPick(pick),
      add: (peakNm, angleDeg) => this.add(peakNm, angleDeg),
      remove: (pick) => this.remove(pick),
      layout: () => this.drawCurve(),
    });
    this.plot.curves.append(...this.lines);
    this.shape = new NumberControl({ label: "Shape", from: 0, to: 1, step: 0.01 }, (shape, gesture) =>
      page.doc.set({ shape }, gesture, materialPath(page.material!)),
    );
    const adder = el("button", { click: () => this.addBeside(), title: "Or double-click the plane" }, "Add pick");
    byId("plane-tools").append(this.shape.element, adder, this.remover);
  }

  show(): void {
    const { material, pick: selected, doc } = this.page;
    if (!material?.curve) return;
    const picks = material.picks!;
    const squares = picks.map(({ peakNm, angleDeg, rgb }, i) => {
      const text = `${short(peakNm)} nm at ${short(angleDeg)}°`;
      const said = { name: `Pick ${i + 1} of ${picks.length}`, text };
      return { x: peakNm, y: angleDeg, colour: hex(rgb), ...said, isSelected: i === selected };
    });
    this.plot.show(squares);
    this.shape.show(Number(material.shape?.toFixed(3)), doc.has(`${materialPath(material)}.shape`));
    this.remover.disabled = picks.length < 2;
    this.drawCurve();
    this.table.update(this.page.here, doc.light, picks[selected]?.flatness ?? 0);
    // The colour of a band at every peak and angle, with the width, height and floor that the curve has at the angle.
    paint(this.plot.field, this.table.columns.length, rows, (column, row, rgb) => {
      const { height, floor, widthNm } = material.curve![90 - 2 * row]!;
      for (let i = 0; i < 3; ++i) rgb[i] = (height - floor) * this.table.at(column, widthNm, i) + floor;
    });
  }

  private move(index: number, peakNm: number, angleDeg: number, gesture: string): void {
    const pick = this.page.material!.picks![index]!;
    const changes: Record<string, number> = {};
    if (Math.abs(peakNm - pick.peakNm) >= 1) changes.peak_nm = peakNm;
    if (Math.abs(angleDeg - pick.angleDeg) >= 1) changes.angle_deg = angleDeg;
    if (Object.keys(changes).length > 0) changeBand(this.page, index, changes, gesture);
  }

  // The new pick has the width and the height that the curve has at its angle.
  private add(peakNm: number, angleDeg: number): void {
    const { picks, curve } = this.page.material!;
    while (picks!.some((pick) => Math.abs(pick.angleDeg - angleDeg) < 1)) angleDeg = (angleDeg + 15) % 91;
    const { height, widthNm, ...rest } = curve![Math.round(angleDeg)]!;
    const band = bandOf({ ...rest, height: Math.max(height, 0.1), widthNm: Math.max(widthNm, 20), peakNm });
    const keys = Object.entries({ angle_deg: angleDeg, ...band }).map(([key, value]) => `${key} = ${value}`);
    this.page.doc.addItem(`${materialPath(this.page.material!)}.picks`, `{ ${keys.join(", ")} }`);
    this.plot.focusSquare(picks!.length);
  }

  // In the middle of the largest gap between the angles of the picks.
  private addBeside(): void {
    const { picks, curve } = this.page.material!;
    const angles = [0, ...picks!.map((pick) => pick.angleDeg), 90].sort((a, b) => a - b);
    const gaps = angles.slice(1).map((angle, i) => ({ size: angle - angles[i]!, middle: (angle + angles[i]!) / 2 }));
    const angleDeg = Math.round(gaps.reduce((a, b) => (b.size > a.size ? b : a)).middle);
    this.add(Math.round(clamp(curve![angleDeg]!.peakNm, peaks.from, peaks.to)), angleDeg);
  }

  private remove(index: number): void {
    const { material, doc } = this.page;
    if (material!.picks!.length < 2) return;
    doc.remove(`${materialPath(material!)}.picks[${index}]`);
    this.page.selectPick(Math.max(0, index - 1));
    this.plot.focusSquare(this.page.pick);
  }

  private drawCurve(): void {
    const curve = this.page.material?.curve ?? [];
    const point = (nm: number, angle: number): string =>
      `${this.plot.px(clamp(nm, peaks.from, peaks.to)).toFixed(1)} ${this.plot.py(angle).toFixed(1)}`;
    const side = (sign: number): string[] =>
      curve.map((band, angle) => point(band.peakNm + (sign * band.widthNm) / 2, angle));
    const middle = curve.flatMap((band, angle) => (band.peakNm < peaks.from ? [] : [point(band.peakNm, angle)]));
    const dark = curve.findIndex((band) => band.height <= 0 && band.floor <= 0);
    const end = dark < 0 ? [] : [point(peaks.from, dark), point(peaks.to, dark)];
    [[...side(-1), ...side(1).reverse()], middle, middle, end].forEach((points, i) =>
      this.lines[i]!.setAttribute("d", points.length === 0 ? "" : `M${points.join("L")}`),
    );
  }
}
