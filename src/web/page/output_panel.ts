// The controls of the output window: what is lit, from where, and how.

import { byId, el, NumberControl } from "./dom";
import type { OutputView } from "./output";

const objects = ["sphere", "wing", "elytra", "car", "bubble", "disc"] as const;
type ObjectName = (typeof objects)[number];

/** The object that shows a scene best, by the scene's name. */
export function objectFor(scene: string): ObjectName {
  const rules: [RegExp, ObjectName][] = [
    [/morpho|feather/, "wing"],
    [/beetle/, "elytra"],
    [/disc|foil|dvd/, "disc"],
    [/soap|window|bubble/, "bubble"],
    [/coating|metal|anodised/, "car"],
  ];
  return rules.find(([words]) => words.test(scene))?.[1] ?? "sphere";
}

export class OutputPanel {
  private readonly light: [number, number] = [-40, 50];

  constructor(private readonly view: OutputView) {
    byId("objects").append(
      ...objects.map((name) =>
        el("label", {}, el("input", { type: "radio", name: "object", value: name, change: () => this.choose(name) }), name),
      ),
    );
    const environment = byId<HTMLInputElement>("environment");
    environment.addEventListener("change", () => this.set({ environment: environment.checked }));
    this.number("Roughness", 0, 1, 0.01, 0.2, (roughness) => this.set({ roughness }));
    this.number("Exposure", -4, 4, 0.1, 0, (exposure) => this.set({ exposure }), "EV");
    this.number("Light around", -180, 180, 1, this.light[0], (angle) => this.turnLight(0, angle), "°");
    this.number("Light up", -10, 90, 1, this.light[1], (angle) => this.turnLight(1, angle), "°");
    this.set({ environment: environment.checked, roughness: 0.2, exposure: 0, light: this.light });
  }

  choose(name: ObjectName): void {
    for (const radio of document.querySelectorAll<HTMLInputElement>("#objects input")) radio.checked = radio.value === name;
    this.view.setObject(name);
    this.view.draw();
  }

  private turnLight(axis: 0 | 1, angle: number): void {
    this.light[axis] = angle;
    this.set({ light: this.light });
  }

  private set(changes: Parameters<OutputView["set"]>[0]): void {
    this.view.set(changes);
    this.view.draw();
  }

  private number(
    label: string,
    from: number,
    to: number,
    step: number,
    first: number,
    change: (value: number) => void,
    unit?: string,
  ): void {
    const control = new NumberControl({ label, from, to, step, ...(unit ? { unit } : {}) }, (value) => {
      control.show(value);
      change(value);
    });
    control.show(first);
    byId("output-numbers").append(control.element);
  }
}
