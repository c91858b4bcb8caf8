// A tab for each mechanism, with the main numbers of the shown material as sliders.

import type { Material } from "./api";
import { materialPath } from "./document";
import { byId, el, NumberControl, type NumberSpec } from "./dom";
import type { NacrePage } from "./main";

/** A number of a material by its key; `standard` is what nacre takes if the scene does not say it. */
interface Key extends NumberSpec {
  key: string;
  standard?: number;
}
interface Row {
  element: Node;
  show(): void;
}

const key = (name: string, label: string, from: number, to: number, step: number, standard?: number): Key => {
  const unit = { nm: "nm", um: "µm", deg: "°" }[/_(nm|um|deg)$/.exec(name)?.[1] ?? ""] ?? "";
  const isLogarithmic = from > 0 && to / from > 1e4;
  return { key: name, label, unit, from, to, step, isLogarithmic, ...(standard === undefined ? {} : { standard }) };
};
const facets = [key("tilt_deg", "Tilt", 0, 60, 0.5, 0), key("roughness", "Roughness", 0, 1, 0.01, 0)];
const layered = [key("thickness_spread_nm", "Spread", 0, 60, 1, 0), ...facets, key("base", "Base", 0, 1, 0.01, 0)];
const keys: Record<string, Key[]> = {
  palette: facets,
  film: [key("thickness_nm", "Thickness", 0, 1500, 1), ...layered],
  stack: [
    key("repeat", "Repeats", 1, 40, 1),
    key("thickness_nm", "Thickness", 1, 600, 1),
    key("films", "Films", 1, 40, 1),
    key("film_nm", "Film", 1, 400, 1),
    key("gap_nm", "Gap", 1, 400, 1),
    ...layered,
  ],
  grating: [
    key("period_nm", "Period", 400, 5000, 10),
    key("grooves", "Grooves", 1, 200, 1, 100),
    key("depth_nm", "Depth", 10, 400, 1),
    key("land", "Land", 0, 1, 0.01, 0.5),
    key("azimuth_deg", "Azimuth", 0, 90, 1, 0),
  ],
  crystal: [key("diameter_nm", "Diameter", 120, 600, 1), key("planes", "Planes", 1, 100, 1, 30), ...layered],
  scatter: [
    key("radius_nm", "Radius", 1, 300, 1),
    key("radius_spread", "Spread", 0, 0.5, 0.01, 0),
    key("volume_fraction", "Volume share", 1e-6, 0.6, 0.01),
    key("thickness_um", "Thickness", 0.1, 1e6, 1),
  ],
  measured: facets,
};
const layers = ["film", "stack", "crystal"];
const indices: Record<string, string> = {
  ...{ incident: "In front", index: "Index", film: "Film", gap: "Gap", substrate: "Substrate" },
  ...{ sphere: "Spheres", medium: "Medium", particle: "Particles", coat: "Coat" },
};
// An index that is a table or a list, and one that the scene does not say.
const unnamed = ["as in the text", "default"];
const starts: Record<string, string> = {
  palette: `picks = [
    { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1.0 },
    { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 },
]`,
  film: 'index = "water"\nthickness_nm = 400\nsubstrate = 1',
  stack: `layers = [
    { repeat = 8, layers = [ { index = 1.7, thickness_nm = 78 }, { index = 1.6, thickness_nm = 83 } ] },
]
substrate = "melanin"`,
  grating: 'period_nm = 1600\ngrooves = 40\ndepth_nm = 175\nland = 0.69\ncoat = "al"',
  crystal: 'sphere = 1.46\nmedium = "water"\ndiameter_nm = 260\nplanes = 40\nsubstrate = 1.43',
  scatter: `model = "quasi_ordered"
particle = 1
medium = "keratin"
radius_nm = 75
radius_spread = 0.08
volume_fraction = 0.45
thickness_um = 3`,
};

export class MechanismsPanel {
  private readonly tabs = new Map<string, HTMLButtonElement>();
  private rows: Row[] = [];
  private shape = "";
  /** A tab that the scene has no material for. */
  private offered = "";

  constructor(private readonly page: NacrePage) {
    for (const name of Object.keys(keys)) {
      const walk = (event: KeyboardEvent): void => this.walk(name, event.key);
      const tab = el("button", { role: "tab", id: `tab-${name}`, click: () => this.choose(name), keydown: walk }, name);
      tab.setAttribute("aria-controls", "mechanism-panel");
      this.tabs.set(name, tab);
    }
    byId("mechanisms").append(...this.tabs.values());
  }

  show(): void {
    const { material, doc } = this.page;
    const shown = this.offered || (material?.mechanism ?? "palette");
    const present = doc.scene.materials.map(({ mechanism }) => mechanism);
    for (const [name, tab] of this.tabs) {
      tab.hidden = name === "measured" && !present.includes(name);
      tab.setAttribute("aria-selected", String(name === shown));
      tab.tabIndex = name === shown ? 0 : -1;
    }
    byId("mechanism-panel").setAttribute("aria-labelledby", `tab-${shown}`);
    byId("picks").hidden = this.offered !== "" || !material?.curve;
    byId("mechanism-controls").hidden = this.offered !== "";
    byId("mechanism-offer").hidden = this.offered === "";
    if (this.offered === "" && material) this.showControls(material);
  }

  /** The tab of the shown material is shown. */
  reset(): void {
    this.offered = "";
  }

  private choose(mechanism: string): void {
    const { doc, material } = this.page;
    const names = doc.scene.materials.filter((one) => one.mechanism === mechanism).map(({ name }) => name);
    const lut = doc.scene.luts.find((one) => names.includes(one.material));
    this.offered = lut ? "" : mechanism;
    if (lut && material?.mechanism !== mechanism) this.page.selectLut(lut.name);
    if (!lut) this.offer(mechanism);
    this.show();
  }

  private offer(mechanism: string): void {
    const word = mechanism === "palette" ? "" : `mechanism = "${mechanism}"\n`;
    const text = `nacre = 1\n\n[material.${mechanism}]\n${word}${starts[mechanism]}\n`;
    const start = (): void => this.page.open(mechanism, text);
    byId("mechanism-offer").replaceChildren(
      el("p", {}, `This scene has no ${mechanism}.`),
      el("button", { class: "primary", click: start }, `Start a ${mechanism}`),
      el("p", { class: "note" }, "It replaces the scene. Undo brings it back."),
    );
  }

  private walk(from: string, key: string): void {
    const way = { ArrowRight: 1, ArrowLeft: -1 }[key];
    if (way === undefined) return;
    const names = [...this.tabs.keys()].filter((name) => !this.tabs.get(name)!.hidden);
    const next = names[(names.indexOf(from) + way + names.length) % names.length]!;
    this.choose(next);
    this.tabs.get(next)!.focus();
  }

  // The controls are made anew when the scene has other numbers, and keep the focus when it has only other values.
  private showControls(material: Material): void {
    const { values } = this.page.doc.scene;
    const root = `${materialPath(material)}.`;
    const order = (path: string): number => values[path]!.place.line * 1e4 + values[path]!.place.column;
    const given = Object.keys(values).filter((path) => path.startsWith(root)).sort((a, b) => order(a) - order(b));
    const shape = [material.mechanism, ...given.map((path) => path + typeof values[path]!.value)].join();
    if (shape !== this.shape) {
      this.shape = shape;
      const paths = [...given, ...this.standards(material.mechanism, root, given)];
      this.rows = paths.flatMap((path) => this.rowOf(path, root, material.mechanism));
      byId("mechanism-controls").replaceChildren(...this.rows.map(({ element }) => element));
    }
    for (const row of this.rows) row.show();
  }

  // What the scene leaves to nacre's defaults. Tilt and roughness exclude each other.
  private standards(mechanism: string, root: string, given: string[]): string[] {
    const hasFacets = facets.some((facet) => given.includes(root + facet.key));
    const isMissing = (name: string): boolean => !given.some((path) => path.startsWith(root + name));
    const left = keys[mechanism]!.filter((one) => one.standard !== undefined && !(hasFacets && facets.includes(one)));
    const names = [...(layers.includes(mechanism) ? ["substrate"] : []), ...left.map((one) => one.key)];
    return names.filter(isMissing).map((name) => root + name);
  }

  private rowOf(path: string, root: string, mechanism: string): Row[] {
    const inside = path.slice(root.length);
    const end = inside.slice(inside.lastIndexOf(".") + 1);
    if (inside !== end && !inside.startsWith("layers[")) return [];
    const layer = [...inside.matchAll(/layers\[(\d+)\]/g)].map((match) => Number(match[1]) + 1).join(".");
    const found = keys[mechanism]!.find((one) => one.key === end);
    const value = this.page.doc.scene.values[path];
    const label = `${layer} ${found?.label ?? indices[end]}`.trim();
    if (found && (!value || typeof value.value === "number")) return [this.numberRow(path, label, found)];
    return indices[end] ? [this.indexRow(path, label)] : [];
  }

  private numberRow(path: string, label: string, spec: Key): Row {
    const { doc } = this.page;
    const control = new NumberControl({ ...spec, label }, (value, gesture) => doc.set({ [path]: value }, gesture));
    const show = (): void => control.show((doc.value(path) as number | undefined) ?? spec.standard, doc.has(path));
    return { element: control.element, show };
  }

  // A number, or the name of a shipped material.
  private indexRow(path: string, label: string): Row {
    const { doc, here } = this.page;
    const spec = { label, from: 1, to: 4, step: 0.01 };
    const control = new NumberControl(spec, (value, gesture) => doc.set({ [path]: value }, gesture));
    const options = here.shippedMaterials().map(({ name, about }) => el("option", { value: name, title: about }, name));
    const choose = (): void => {
      if (!unnamed.includes(select.value)) doc.set({ [path]: select.value === "" ? 1.5 : select.value });
    };
    const select = el("select", { "aria-label": `${label}: material`, change: choose });
    select.append(el("option", { value: "" }, "number"), ...options);
    control.element.lastElementChild!.replaceWith(select);
    control.element.classList.add("index");
    const show = (): void => {
      const value = doc.value(path);
      const other = String(value ?? unnamed[doc.has(path) ? 0 : 1]);
      const isNumber = typeof value === "number";
      if (!isNumber && !options.some((option) => option.value === other)) {
        options.push(el("option", { value: other }, other));
        select.append(options.at(-1)!);
      }
      select.value = isNumber ? "" : other;
      control.element.classList.toggle("named", !isNumber);
      if (isNumber) control.show(value);
    };
    return { element: control.element, show };
  }
}
