// The controls of the output window: what is lit, from where, and how.

import type { Axis } from "./api";
import { byId, el, NumberControl } from "./dom";
import type { OutputView } from "./output";

const objects = ["sphere", "wing", "elytra", "car", "bubble", "disc"] as const;
type ObjectName = (typeof objects)[number];

// The object that shows a scene best, by words in the scene's name.
const suited: Partial<Record<ObjectName, RegExp>> = {
  ...{ wing: /morpho|feather/, elytra: /beetle/, disc: /disc|foil|grating/ },
  ...{ bubble: /soap|window|film$/, car: /coating|metal/ },
};

export class OutputPanel {
  private light: [number, number] = [-40, 50];
  private row: NumberControl | undefined;
  private axis = "";

  constructor(private readonly view: OutputView) {
    for (const value of objects) {
      const radio = el("input", { type: "radio", name: "object", value, change: () => this.choose(value) });
      byId("objects").append(el("label", {}, radio, value));
    }
    const environment = byId<HTMLInputElement>("environment");
    environment.addEventListener("change", () => view.set({ environment: environment.checked }));
    const number = (label: string, unit: string, from: number, to: number, change: (value: number) => void) => {
      const control = new NumberControl({ label, unit, from, to, step: to > 10 ? 1 : 0.01 }, (value) => {
        control.show(value);
        change(value);
      });
      byId("output-numbers").append(control.element);
      return control;
    };
    number("Roughness", "", 0, 1, (roughness) => view.set({ roughness })).show(0.2);
    number("Exposure", "EV", -4, 4, (exposure) => view.set({ exposure })).show(0);
    const sides = (["Light around", "Light up"] as const).map((label, side) =>
      number(label, "°", [-180, -10][side]!, [180, 90][side]!, (angle) => {
        this.light[side] = angle;
        view.set({ light: [...this.light] });
      }),
    );
    const show = (light: number[]): void => {
      this.light = [Math.round(light[0]!), Math.round(light[1]!)];
      sides.forEach((control, side) => control.show(this.light[side]));
    };
    byId("output-canvas").addEventListener("lightmoved", (event) => show((event as CustomEvent<number[]>).detail));
    show(this.light);
    byId("over-surface").addEventListener("click", () => this.showRow(null));
  }

  chooseFor(scene: string): void {
    this.choose(objects.find((name) => suited[name]?.test(scene)) ?? "sphere");
  }

  /** A second axis runs over the surface until its slider is moved. */
  showAxis(y: Axis | undefined): void {
    const axis = y ? [y.name, y.from, y.to].join() : "";
    if (axis === this.axis) return;
    this.axis = axis;
    byId("row").hidden = y === undefined;
    this.row?.element.remove();
    if (!y) return;
    const spec = { label: y.name.replaceAll("_", " "), from: y.from, to: y.to, step: (y.to - y.from) / 200 };
    this.row = new NumberControl(spec, (value) => {
      this.row!.show(value);
      this.showRow((value - y.from) / (y.to - y.from));
    });
    byId("row").prepend(this.row.element);
    this.showRow(null);
  }

  private showRow(row: number | null): void {
    this.view.set({ row });
    byId("over-surface").ariaPressed = String(row === null);
  }

  private choose(name: ObjectName): void {
    byId("objects").querySelector<HTMLInputElement>(`[value="${name}"]`)!.checked = true;
    this.view.setObject(name);
  }
}
