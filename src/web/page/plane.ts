// The plane of peak wavelength and angle, with one square for each pick, as in the paper's Figure 10.

import type { Engine, Material, Pick } from "./api";
import { byId, clamp, el, hex, mix, NumberControl, paint, short, svg } from "./dom";
import { materialPath, type Page } from "./page";
import { Plot } from "./plot";
import type { TomlValue } from "./toml_text";

const peaks = { from: 360, to: 830, step: 5 };
const widths = { to: 400, step: 20 };
const rows = 46;
type Band = NonNullable<Material["curve"]>[number];
const bandKeys = ["peak_nm", "width_nm", "height", "floor", "flatness"];

/** The numbers of a pick's band, as the scene names them. Floor and flatness are left out where they are 0. */
export function bandOf(pick: Pick): Record<string, TomlValue> {
  const band: Record<string, TomlValue> = {
    peak_nm: Number(pick.peakNm.toFixed(2)),
    width_nm: Number(pick.widthNm.toFixed(2)),
    height: Number(pick.height.toFixed(4)),
  };
  if (pick.floor !== 0) band.floor = Number(pick.floor.toFixed(4));
  if (pick.flatness !== 0) band.flatness = Number(pick.flatness.toFixed(4));
  return band;
}

/** Changes the band of a pick. One that is given as a colour becomes the band that nacre made of it. */
export function changeBand(page: Page, index: number, changes: Record<string, number>, gesture: string): void {
  const pick = page.material?.picks?.[index];
  if (!page.material || !pick) return;
  const path = `${materialPath(page.material)}.picks[${index}]`;
  const isColour = page.doc.value(`${path}.colour`) !== undefined || page.doc.value(`${path}.color`) !== undefined;
  if (isColour && Object.keys(changes).some((key) => bandKeys.includes(key))) {
    const key = page.doc.value(`${path}.colour`) ? "colour" : "color";
    page.doc.exchange(path, { ...bandOf(pick), ...changes }, [key, "space"], gesture);
    return;
  }
  const prefixed = Object.entries(changes).map(([key, value]) => [`${path}.${key}`, value]);
  page.doc.set(Object.fromEntries(prefixed), gesture);
}

/** Colours of bands of height 1 by peak and width. A colour is linear in the height, so one table serves all of a
 *  plane; it depends on the light of the scene and on the flatness. */
class BandTable {
  private key = "";
  private readonly columns: Float32Array[] = [];

  update(engine: Engine, light: string, flatness: number): void {
    const key = `${light} ${flatness}`;
    if (key === this.key) return;
    this.key = key;
    this.columns.length = 0;
    const band = { angleDeg: 0, height: 1, floor: 0, flatness, widthNm: 0, rgb: [0, 0, 0] as [number, number, number] };
    const count = widths.to / widths.step + 1;
    for (let peakNm = peaks.from; peakNm <= peaks.to; peakNm += peaks.step) {
      const field = engine.paletteField({ ...band, peakNm }, widths.to, count, 2);
      this.columns.push(field.slice(count * 3));
    }
  }

  get count(): number {
    return this.columns.length;
  }

  at(column: number, widthNm: number, component: number): number {
    const place = clamp(widthNm, 0, widths.to - 1) / widths.step;
    const left = Math.floor(place);
    const field = this.columns[column]!;
    return mix(field[left * 3 + component]!, field[left * 3 + 3 + component]!, place - left);
  }
}

export class PlanePanel {
  private readonly table = new BandTable();
  private readonly plot: Plot;
  private readonly band = svg("path", { class: "band" });
  private readonly curveBelow = svg("path", { class: "curve below" });
  private readonly curve = svg("path", { class: "curve" });
  private readonly end = svg("path", { class: "height-end" });
  private readonly shape: NumberControl;
  private readonly remover = el("button", { click: () => this.remove(this.page.pick) }, "Delete");

  constructor(private readonly page: Page) {
    const ticks = [400, 450, 500, 550, 600, 650, 700, 750, 800];
    this.plot = new Plot(
      "Picks: peak wavelength and angle",
      { label: "peak wavelength (nm)", from: peaks.from, to: peaks.to, ticks, unit: "nm", step: 1, leap: 10 },
      { label: "angle", from: 0, to: 90, ticks: [0, 15, 30, 45, 60, 75, 90], unit: "°", step: 1, leap: 10 },
      {
        move: (pick, peakNm, angleDeg, gesture) => this.move(pick, peakNm, angleDeg, gesture),
        select: (pick) => page.selectPick(pick),
        add: (peakNm, angleDeg) => this.add(peakNm, angleDeg),
        remove: (pick) => this.remove(pick),
      },
    );
    this.plot.curves.append(this.band, this.curveBelow, this.curve, this.end);
    this.plot.onLayout = () => this.drawCurve();
    this.shape = new NumberControl({ label: "Shape", from: 0, to: 1, step: 0.01 }, (value, gesture) =>
      page.doc.set({ [`${materialPath(page.material!)}.shape`]: value }, gesture),
    );
    const adder = el("button", { click: () => this.addBeside(), title: "Or double-click the plane" }, "Add pick");
    byId("plane").append(this.plot.element);
    byId("plane-tools").append(this.shape.element, adder, this.remover);
  }

  show(): void {
    const { material, pick: selected } = this.page;
    const picks = material?.picks ?? [];
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
    const isShapeGiven = this.page.doc.value(`${materialPath(material)}.shape`) !== undefined;
    this.shape.show(Number(material.shape?.toFixed(3)), isShapeGiven);
    this.remover.disabled = picks.length < 2;
    this.drawCurve();
    this.drawField(material);
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
    const picks = material.picks ?? [];
    while (picks.some((pick) => Math.abs(pick.angleDeg - angleDeg) < 1)) angleDeg = (angleDeg + 15) % 91;
    const curve = material.curve[Math.round(angleDeg)]!;
    const pick = { ...curve, height: Math.max(curve.height, 0.1), widthNm: Math.max(curve.widthNm, 20), peakNm };
    const band = bandOf({ ...pick, angleDeg, rgb: [0, 0, 0] });
    const keys = Object.entries({ angle_deg: angleDeg, ...band }).map(([key, value]) => `${key} = ${value}`);
    doc.addItem(`${materialPath(material)}.picks`, `{ ${keys.join(", ")} }`);
    this.page.selectPick(picks.length);
    this.plot.focusSquare(picks.length);
  }

  // In the middle of the largest gap between the angles of the picks.
  private addBeside(): void {
    const angles = [0, ...this.page.material!.picks!.map((pick) => pick.angleDeg), 90].sort((a, b) => a - b);
    const gaps = angles.slice(1).map((angle, i) => ({ size: angle - angles[i]!, middle: (angle + angles[i]!) / 2 }));
    const angleDeg = Math.round(gaps.reduce((a, b) => (b.size > a.size ? b : a)).middle);
    this.add(Math.round(clamp(this.page.material!.curve![angleDeg]!.peakNm, peaks.from, peaks.to)), angleDeg);
  }

  private remove(index: number): void {
    const { material, doc } = this.page;
    if (!material?.picks || material.picks.length < 2) return;
    doc.remove(`${materialPath(material)}.picks[${index}]`);
    this.page.selectPick(Math.max(0, index - 1));
    this.plot.focusSquare(Math.max(0, index - 1));
  }

  private drawCurve(): void {
    const curve = this.page.material?.curve;
    if (!curve) return;
    const across = (nm: number): string => this.plot.px(clamp(nm, peaks.from, peaks.to)).toFixed(1);
    const line = (nm: (band: Band) => number): string[] =>
      curve.map((band, angle) => `${across(nm(band))} ${this.plot.py(angle).toFixed(1)}`);
    const inside = curve.map((band, angle) => ({ band, angle })).filter(({ band }) => band.peakNm >= peaks.from);
    const points = inside.map(({ band, angle }) => `${across(band.peakNm)} ${this.plot.py(angle).toFixed(1)}`);
    for (const path of [this.curve, this.curveBelow]) path.setAttribute("d", `M${points.join("L")}`);
    const left = line((band) => band.peakNm - band.widthNm / 2);
    const right = line((band) => band.peakNm + band.widthNm / 2).reverse();
    this.band.setAttribute("d", `M${left.join("L")}L${right.join("L")}Z`);
    const dark = curve.findIndex((band) => band.height <= 0 && band.floor <= 0);
    const y = this.plot.py(dark);
    this.end.setAttribute("d", dark < 0 ? "" : `M${across(peaks.from)} ${y}H${across(peaks.to)}`);
  }

  // The colour of a band at every peak and angle, with the width, height and floor that the curve has at the angle.
  private drawField(material: Material): void {
    const { doc, here } = this.page;
    const light = Object.entries(doc.scene.values).filter(([path]) => path.startsWith("light"));
    const flatness = material.picks![this.page.pick]?.flatness ?? 0;
    this.table.update(here, JSON.stringify(light.map(([path, { value }]) => [path, value])), flatness);
    const rgb = [0, 0, 0];
    paint(this.plot.field, this.table.count, rows, (column, row) => {
      const band = material.curve![90 - 2 * row]!;
      for (let i = 0; i < 3; ++i) {
        rgb[i] = (band.height - band.floor) * this.table.at(column, band.widthNm, i) + band.floor;
      }
      return rgb;
    });
  }
}
