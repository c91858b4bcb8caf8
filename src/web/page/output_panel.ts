// The controls of the output window: what is lit, from where, and how.

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

  constructor(private readonly view: OutputView) {
    const radios = objects.map((value) => {
      const radio = el("input", { type: "radio", name: "object", value, change: () => this.choose(value) });
      return el("label", {}, radio, value);
    });
    byId("objects").append(...radios);
    const environment = byId<HTMLInputElement>("environment");
    environment.addEventListener("change", () => this.set({ environment: environment.checked }));
    this.set({ environment: true, light: this.light });
    this.number("Roughness", "", 0, 1, 0.2, (roughness) => this.set({ roughness }));
    this.number("Exposure", "EV", -4, 4, 0, (exposure) => this.set({ exposure }));
    this.number("Light around", "°", -180, 180, this.light[0], (angle) => this.turn([angle, this.light[1]]));
    this.number("Light up", "°", -10, 90, this.light[1], (angle) => this.turn([this.light[0], angle]));
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

  private number(
    ...[label, unit, from, to, first, change]: [string, string, number, number, number, (value: number) => void]
  ): void {
    const show = (value: number): void => {
      control.show(value);
      change(value);
    };
    const control = new NumberControl({ label, unit, from, to, step: to > 10 ? 1 : 0.01 }, show);
    show(first);
    byId("output-numbers").append(control.element);
  }
}
