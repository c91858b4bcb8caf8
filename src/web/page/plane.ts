// The plane of peak wavelength and angle, with one square for each pick, as in the paper's Figure 10.

import type { Engine, Material, Pick } from "./api";
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
  const pick = page.material?.picks?.[index];
  if (!pick) return;
  const path = `${materialPath(page.material!)}.picks[${index}]`;
  const colour = ["colour", "color"].find((key) => page.doc.has(`${path}.${key}`));
  if (colour === undefined || Object.keys(changes).join() === "angle_deg") page.doc.set(changes, gesture, path);
  else page.doc.exchange(path, { ...bandOf(pick), ...changes }, [colour, "space"], gesture);
}

/** Colours of bands of height 1 by peak and width. A colour is linear in the height, so one table serves all of a
 *  plane; it depends on the light of the scene and on the flatness. */
class BandTable {
  readonly columns: Float32Array[] = [];
  private key = "";

  update(engine: Engine, light: string, flatness: number): void {
    const key = `${light} ${flatness}`;
    if (key === this.key) return;
    this.key = key;
    this.columns.length = 0;
    const band: Pick = { angleDeg: 0, peakNm: 0, height: 1, floor: 0, flatness, widthNm: 0, rgb: [0, 0, 0] };
    const count = widths.to / widths.step + 1;
    for (let peakNm = peaks.from; peakNm <= peaks.to; peakNm += peaks.step) {
      this.columns.push(engine.paletteField({ ...band, peakNm }, widths.to, count, 2).slice(count * 3));
    }
  }

  at(column: number, widthNm: number, component: number): number {
    const place = clamp(widthNm, 0, widths.to - 1) / widths.step;
    const at = 3 * Math.floor(place) + component;
    const field = this.columns[column]!;
    return mix(field[at]!, field[at + 3]!, place % 1);
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
    this.plot = new Plot(
      ...(["plane", "Picks: peak wavelength and angle"] as const),
      { label: "peak wavelength (nm)", from: peaks.from, to: peaks.to, ticks, step: 1, leap: 10 },
      { label: "angle (°)", from: 0, to: 90, ticks: [0, 15, 30, 45, 60, 75, 90], step: 1, leap: 10 },
      {
        move: (pick, peakNm, angleDeg, gesture) => this.move(pick, peakNm, angleDeg, gesture),
        select: (pick) => page.selectPick(pick),
        add: (peakNm, angleDeg) => this.add(peakNm, angleDeg),
        remove: (pick) => this.remove(pick),
      },
      () => this.drawCurve(),
    );
    this.plot.curves.append(...this.lines);
    this.shape = new NumberControl({ label: "Shape", from: 0, to: 1, step: 0.01 }, (shape, gesture) =>
      page.doc.set({ shape }, gesture, materialPath(page.material!)),
    );
    const adder = el("button", { click: () => this.addBeside(), title: "Or double-click the plane" }, "Add pick");
    byId("plane-tools").append(this.shape.element, adder, this.remover);
  }

  show(): void {
    const { material, pick: selected, doc } = this.page;
    const picks = material?.curve ? material.picks! : [];
    this.plot.show(
      picks.map((pick, i) => ({
        x: pick.peakNm,
        y: pick.angleDeg,
        colour: hex(pick.rgb),
        name: `Pick ${i + 1} of ${picks.length}`,
        text: `${short(pick.peakNm)} nm at ${short(pick.angleDeg)}°`,
        isSelected: i === selected,
      })),
    );
    if (!material?.curve) return;
    this.shape.show(Number(material.shape?.toFixed(3)), doc.has(`${materialPath(material)}.shape`));
    this.remover.disabled = picks.length < 2;
    this.drawCurve();
    this.table.update(this.page.here, doc.light, picks[selected]?.flatness ?? 0);
    this.drawField(material.curve);
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
    const { material, doc } = this.page;
    if (!material?.curve) return;
    const picks = material.picks!;
    while (picks.some((pick) => Math.abs(pick.angleDeg - angleDeg) < 1)) angleDeg = (angleDeg + 15) % 91;
    const curve = material.curve[Math.round(angleDeg)]!;
    const height = Math.max(curve.height, 0.1);
    const band = bandOf({ ...curve, height, widthNm: Math.max(curve.widthNm, 20), peakNm });
    const keys = Object.entries({ angle_deg: angleDeg, ...band }).map(([key, value]) => `${key} = ${value}`);
    doc.addItem(`${materialPath(material)}.picks`, `{ ${keys.join(", ")} }`);
    this.plot.focusSquare(picks.length);
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
    if (!material?.picks || material.picks.length < 2) return;
    doc.remove(`${materialPath(material)}.picks[${index}]`);
    this.page.selectPick(Math.max(0, index - 1));
    this.plot.focusSquare(this.page.pick);
  }

  private drawCurve(): void {
    const curve = this.page.material?.curve;
    if (!curve) return;
    const point = (nm: number, angle: number): string =>
      `${this.plot.px(clamp(nm, peaks.from, peaks.to)).toFixed(1)} ${this.plot.py(angle).toFixed(1)}`;
    const side = (sign: number): string[] =>
      curve.map((band, angle) => point(band.peakNm + (sign * band.widthNm) / 2, angle));
    const middle = curve.flatMap((band, angle) => (band.peakNm < peaks.from ? [] : [point(band.peakNm, angle)]));
    const dark = curve.findIndex((band) => band.height <= 0 && band.floor <= 0);
    const paths = [
      `M${side(-1).join("L")}L${side(1).reverse().join("L")}Z`,
      ...[1, 2].map(() => (middle.length > 0 ? `M${middle.join("L")}` : "")),
      dark < 0 ? "" : `M${point(peaks.from, dark)}L${point(peaks.to, dark)}`,
    ];
    this.lines.forEach((line, i) => line.setAttribute("d", paths[i]!));
  }

  // The colour of a band at every peak and angle, with the width, height and floor that the curve has at the angle.
  private drawField(curve: Band[]): void {
    paint(this.plot.field, this.table.columns.length, rows, (column, row, rgb) => {
      const { height, floor, widthNm } = curve[90 - 2 * row]!;
      for (let i = 0; i < 3; ++i) rgb[i] = (height - floor) * this.table.at(column, widthNm, i) + floor;
    });
  }
}
