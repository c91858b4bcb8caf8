// The palette: width against height of the selected pick, its other numbers, and its colour.

import type { Pick } from "./api";
import { byId, el, hex, mix, NumberControl, paint, short } from "./dom";
import { materialPath, type Page } from "./page";
import { changeBand } from "./plane";
import { Plot } from "./plot";

interface EyeDropperLike {
  open(): Promise<{ sRGBHex: string }>;
}

const columns = 64;
const rows = 32;

export class PalettePanel {
  private plot: Plot;
  private fieldKey = "";
  private readonly controls: Record<string, NumberControl> = {};
  private readonly native = el("input", { type: "color", "aria-label": "Colour of the pick" });
  private readonly text = el("input", { type: "text", class: "hex", "aria-label": "Colour of the pick, #rrggbb" });
  private readonly made = el("span", { class: "made" });
  private readonly note = el("p", { class: "note", role: "status" });
  private gesture = 0;

  constructor(private readonly page: Page) {
    this.plot = this.newPlot(200);
    const add = (key: string, label: string, from: number, to: number, step: number, unit?: string): void => {
      const spec = { label, from, to, step, ...(unit ? { unit } : {}) };
      const control = new NumberControl(spec, (value, gesture) =>
        changeBand(page, page.pick, { [key]: value }, gesture),
      );
      this.controls[key] = control;
      byId(key.startsWith("f") ? "pick-sliders" : "pick-numbers").append(control.element);
    };
    add("angle_deg", "Angle", 0, 90, 1, "°");
    add("peak_nm", "Peak", 360, 830, 1, "nm");
    add("width_nm", "Width", 1, 500, 1, "nm");
    add("height", "Height", 0, 1, 0.01);
    add("floor", "Floor", 0, 1, 0.01);
    add("flatness", "Flatness", 0, 0.99, 0.01);
    this.native.addEventListener("input", () => this.setColour(this.native.value));
    this.native.addEventListener("change", () => ++this.gesture);
    this.text.addEventListener("change", () => this.setColour(this.text.value.trim()));
    byId("colour").append(this.native, this.text, ...this.dropper(), this.made, this.note);
  }

  show(): void {
    const pick = this.page.material?.picks?.[this.page.pick];
    if (!pick) return;
    const most = pick.widthNm <= 200 ? 200 : pick.widthNm <= 400 ? 400 : 800;
    if (most !== this.plot.x.to && !this.plot.element.contains(document.activeElement)) {
      this.plot.element.remove();
      this.plot = this.newPlot(most);
    }
    byId("palette-title").textContent = `Pick ${this.page.pick + 1}: width and height`;
    const text = `${short(pick.widthNm)} nm, height ${short(pick.height)}`;
    this.plot.show([
      { x: pick.widthNm, y: pick.height, colour: hex(pick.rgb), name: "Width and height", text, isSelected: true },
    ]);
    const numbers = { angle_deg: pick.angleDeg, peak_nm: pick.peakNm, width_nm: pick.widthNm, height: pick.height };
    const all: Record<string, number> = { ...numbers, floor: pick.floor, flatness: pick.flatness };
    for (const [key, control] of Object.entries(this.controls)) control.show(all[key], pick.colour === undefined);
    this.showColour(pick);
    this.drawField(pick);
  }

  private newPlot(mostNm: number): Plot {
    const ticks = [0, 1, 2, 3, 4].map((quarter) => (quarter * mostNm) / 4);
    const plot = new Plot(
      "Palette: width and height",
      { label: "width (nm)", from: 0, to: mostNm, ticks, unit: "nm", step: 1, leap: 10 },
      { label: "height", from: 0, to: 1, ticks: [0, 0.25, 0.5, 0.75, 1], unit: "", step: 0.01, leap: 0.1 },
      {
        move: (_, width, height, gesture) =>
          changeBand(this.page, this.page.pick, { width_nm: Math.max(width, 1), height }, gesture),
        select: () => {},
      },
    );
    byId("palette").append(plot.element);
    this.fieldKey = "";
    return plot;
  }

  private dropper(): HTMLElement[] {
    const Dropper = (window as unknown as { EyeDropper?: new () => EyeDropperLike }).EyeDropper;
    if (!Dropper) return [];
    const take = async (): Promise<void> => {
      const taken = await new Dropper().open().catch(() => undefined);
      if (taken) this.setColour(taken.sRGBHex);
    };
    return [el("button", { click: () => void take(), title: "Take a colour from the screen" }, "Eyedropper")];
  }

  private setColour(colour: string): void {
    const { material, pick, doc } = this.page;
    if (!material || !/^#?([0-9a-f]{3}|[0-9a-f]{6})$/i.test(colour)) {
      this.page.say(`"${colour}" is not a colour; write it as #22aa44`);
      return;
    }
    const path = `${materialPath(material)}.picks[${pick}]`;
    const key = doc.value(`${path}.color`) ? "color" : "colour";
    const removed = ["peak_nm", "width_nm", "height", "floor", "flatness", "space"];
    const written = `#${colour.replace("#", "").toLowerCase()}`;
    const gone = removed.filter((name) => doc.value(`${path}.${name}`) !== undefined);
    doc.exchange(path, { [key]: written }, gone, `colour ${this.gesture}`);
  }

  private showColour(pick: Pick): void {
    const shown = hex(pick.rgb);
    const asked = pick.colour?.startsWith("#") ? pick.colour : shown;
    if (document.activeElement !== this.native) this.native.value = asked.length === 7 ? asked : shown;
    if (document.activeElement !== this.text) this.text.value = asked;
    this.made.style.background = shown;
    this.made.title = `What the palette shows: ${shown}`;
    const isOutside = pick.rgb.some((component) => component < -0.002 || component > 1.002);
    const plain = isOutside ? "a colour outside sRGB" : "";
    this.note.textContent = pick.colour === undefined ? plain : `${pick.colour}: ${pick.note ?? "exact"}`;
  }

  // Two rows are enough: colours are linear in the height.
  private drawField(pick: Pick): void {
    const most = this.plot.x.to;
    const key = [pick.peakNm, pick.floor, pick.flatness, most].join();
    if (key === this.fieldKey) return;
    this.fieldKey = key;
    const field = this.page.here.paletteField(pick, most, columns, 2);
    const rgb = [0, 0, 0];
    paint(this.plot.field, columns, rows, (column, row) => {
      for (let i = 0; i < 3; ++i) {
        rgb[i] = mix(field[3 * column + i]!, field[3 * (columns + column) + i]!, 1 - row / (rows - 1));
      }
      return rgb;
    });
  }
}
