// The palette: width against height of the selected pick, its other numbers, and its colour.

import type { Pick } from "./api";
import { materialPath } from "./document";
import { byId, el, hex, mix, NumberControl, paint, short } from "./dom";
import type { NacrePage } from "./main";
import { changeBand } from "./plane";
import { Plot } from "./plot";

type Dropper = new () => { open(): Promise<{ sRGBHex: string }> };
type Spec = [label: string, unit: string, from: number, to: number, step: number];
const columns = 64;
const rows = 32;
const bandKeys = ["peak_nm", "width_nm", "height", "floor", "flatness"];

export class PalettePanel {
  private plot = this.newPlot(200);
  private fieldKey = "";
  private gesture = 0;
  private readonly controls: NumberControl[];
  private readonly native = el("input", { type: "color", "aria-label": "Colour of the pick" });
  private readonly text = el("input", { type: "text", class: "hex", "aria-label": "Colour of the pick, #rrggbb" });
  private readonly made = el("span", { class: "made" });
  private readonly note = el("p", { class: "note", role: "status" });

  constructor(private readonly page: NacrePage) {
    const specs: Spec[] = [["Angle", "°", 0, 90, 1], ["Peak", "nm", 360, 830, 1], ["Width", "nm", 1, 500, 1]];
    specs.push(["Height", "", 0, 1, 0.01], ["Floor", "", 0, 1, 0.01], ["Flatness", "", 0, 0.99, 0.01]);
    this.controls = specs.map(([label, unit, from, to, step], i) => {
      const key = ["angle_deg", ...bandKeys][i]!;
      const change = (value: number, gesture: string): void => changeBand(page, page.pick, { [key]: value }, gesture);
      const control = new NumberControl({ label, unit, from, to, step }, change);
      byId(key.startsWith("fl") ? "pick-sliders" : "pick-numbers").append(control.element);
      return control;
    });
    this.native.addEventListener("input", () => this.setColour(this.native.value));
    this.native.addEventListener("change", () => ++this.gesture);
    this.text.addEventListener("change", () => this.setNewColour(this.text.value.trim()));
    const shows = el("span", { class: "dim" }, "shows");
    byId("colour").append(this.native, this.text, ...this.dropper(), shows, this.made, this.note);
  }

  show(): void {
    const pick = this.page.material?.curve && this.page.material.picks?.[this.page.pick];
    if (!pick) return;
    const most = pick.widthNm <= 200 ? 200 : pick.widthNm <= 400 ? 400 : 800;
    if (most !== this.plot.x.to && !byId("palette").contains(document.activeElement)) this.plot = this.newPlot(most);
    byId("palette-title").textContent = `Pick ${this.page.pick + 1}: width and height`;
    const { angleDeg, peakNm, widthNm, height, floor, flatness } = pick;
    const said = { name: "Width and height", text: `${short(widthNm)} nm, height ${short(height)}` };
    this.plot.show([{ x: widthNm, y: height, colour: hex(pick.rgb), ...said, isSelected: true }]);
    [angleDeg, peakNm, widthNm, height, floor, flatness].forEach((value, i) => this.controls[i]!.show(value));
    this.showColour(pick, hex(pick.rgb));
    this.drawField(pick);
  }

  private newPlot(mostNm: number): Plot {
    const ticks = [0, 1, 2, 3, 4].map((quarter) => (quarter * mostNm) / 4);
    const x = { label: "width (nm)", from: 0, to: mostNm, ticks, step: 1, leap: 10 };
    const y = { label: "height", from: 0, to: 1, ticks: [0, 0.25, 0.5, 0.75, 1], step: 0.01, leap: 0.1 };
    this.fieldKey = "";
    return new Plot("palette", "Palette: width and height", x, y, {
      move: (_, widthNm, height, gesture) =>
        changeBand(this.page, this.page.pick, { width_nm: Math.max(widthNm, 1), height }, gesture),
    });
  }

  private dropper(): HTMLElement[] {
    const { EyeDropper } = window as unknown as { EyeDropper?: Dropper };
    if (!EyeDropper) return [];
    const take = async (): Promise<void> => {
      const taken = await new EyeDropper().open().catch(() => undefined);
      if (taken) this.setNewColour(taken.sRGBHex);
    };
    return [el("button", { click: () => void take(), title: "Take a colour from the screen" }, "Eyedropper")];
  }

  // Each is a step of its own in undo, where the native picker sends many colours of one step.
  private setNewColour(colour: string): void {
    ++this.gesture;
    this.setColour(colour);
  }

  private setColour(colour: string): void {
    const { material, pick, doc } = this.page;
    if (!/^#?([0-9a-f]{3}|[0-9a-f]{6})$/i.test(colour)) {
      return this.page.say(`"${colour}" is not a colour; write it as #22aa44`);
    }
    const path = `${materialPath(material!)}.picks[${pick}]`;
    const given = [...bandKeys, "space", "color"].filter((key) => doc.has(`${path}.${key}`));
    doc.exchange(path, { colour: `#${colour.replace("#", "").toLowerCase()}` }, given, `colour ${pick} ${this.gesture}`);
  }

  private showColour({ colour, rgb, note = "exact" }: Pick, shown: string): void {
    const asked = colour?.startsWith("#") ? colour : shown;
    if (document.activeElement !== this.native) this.native.value = asked.length === 7 ? asked : shown;
    if (document.activeElement !== this.text) this.text.value = asked;
    this.made.style.background = shown;
    this.made.title = `What the palette shows: ${shown}`;
    const isOutside = rgb.some((component) => component < -0.002 || component > 1.002);
    this.note.textContent = colour ? `${colour}: ${note}` : isOutside ? "a colour outside sRGB" : "";
  }

  // Two rows are enough: colours are linear in the height.
  private drawField(pick: Pick): void {
    const key = [this.page.doc.light, pick.peakNm, pick.floor, pick.flatness, this.plot.x.to].join();
    if (key === this.fieldKey) return;
    this.fieldKey = key;
    const field = this.page.here.paletteField(pick, this.plot.x.to, columns, 2);
    paint(this.plot.field, columns, rows, (column, row, rgb) => {
      const height = 1 - row / (rows - 1);
      for (let i = 0; i < 3; ++i) rgb[i] = mix(field[3 * column + i]!, field[3 * (columns + column) + i]!, height);
    });
  }
}
