// The controls of the output window: what is lit, from where, and how.

import type { Axis } from "./api";
import { byId, el, NumberControl } from "./dom";
import type { OutputView } from "./output";

const objects = ["sphere", "wing", "elytra", "car", "bubble", "disc"] as const;
type ObjectName = (typeof objects)[number];

// The object that shows a scene best, by words in the scene's name.
const suited: [RegExp, ObjectName][] = [
  [/morpho|feather/, "wing"],
  [/beetle/, "elytra"],
  [/disc|foil|grating/, "disc"],
  [/soap|window|film$/, "bubble"],
  [/coating|metal/, "car"],
];

export class OutputPanel {
  private light: [number, number] = [-40, 50];
  private row: NumberControl | undefined;
  private axis = "";

  constructor(private readonly view: OutputView) {
    const radios = objects.map((value) => {
      const radio = el("input", { type: "radio", name: "object", value, change: () => this.choose(value) });
      return el("label", {}, radio, value);
    });
    byId("objects").append(...radios);
    const environment = byId<HTMLInputElement>("environment");
    environment.addEventListener("change", () => this.set({ environment: environment.checked }));
    this.set({ environment: true, light: this.light });
    const number = (label: string, unit: string, from: number, to: number, change: (value: number) => void) => {
      const control = new NumberControl({ label, unit, from, to, step: to > 10 ? 1 : 0.01 }, (value) => {
        control.show(value);
        change(value);
      });
      byId("output-numbers").append(control.element);
      return control;
    };
    number("Roughness", "", 0, 1, (roughness) => this.set({ roughness })).show(0.2);
    number("Exposure", "EV", -4, 4, (exposure) => this.set({ exposure })).show(0);
    const around = number("Light around", "°", -180, 180, (angle) => this.turn([angle, this.light[1]]));
    const up = number("Light up", "°", -10, 90, (angle) => this.turn([this.light[0], angle]));
    view.onLightMoved = (light) => {
      this.light = light;
      around.show(Math.round(light[0]));
      up.show(Math.round(light[1]));
    };
    view.onLightMoved(this.light);
    byId("over-surface").addEventListener("click", () => this.overSurface());
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
      this.set({ row: (value - y.from) / (y.to - y.from) });
    });
    byId("row").prepend(this.row.element);
    this.overSurface();
  }

  private overSurface(): void {
    this.row?.show(undefined, false);
    this.set({ row: null });
  }

  chooseFor(scene: string): void {
    this.choose(suited.find(([words]) => words.test(scene))?.[1] ?? "sphere");
  }

  private choose(name: ObjectName): void {
    byId("objects").querySelector<HTMLInputElement>(`[value="${name}"]`)!.checked = true;
    this.view.setObject(name);
    this.view.draw();
  }

  private turn(light: [number, number]): void {
    this.light = light;
    this.set({ light });
  }

  private set(changes: Parameters<OutputView["set"]>[0]): void {
    this.view.set(changes);
    this.view.draw();
  }
}
