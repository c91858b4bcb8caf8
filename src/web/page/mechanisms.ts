// A tab for each mechanism, with the main numbers of the shown material as sliders.

import type { Material } from "./api";
import { materialPath } from "./document";
import { byId, el, NumberControl, type NumberSpec } from "./dom";
import type { NacrePage } from "./main";

type Row = { element: Node; show(): void };

// Key, label, range, step, and what nacre takes if the scene does not say it.
const facets = ["tilt_deg|Tilt|0|60|0.5|0", "roughness|Roughness|0|1|0.01|0"];
const layered = ["thickness_spread_nm|Spread|0|60|1|0", ...facets, "base|Base|0|1|0.01|0"];
const keys: Record<string, string[]> = {
  palette: facets,
  film: ["thickness_nm|Thickness|0|1500|1", ...layered],
  stack: [
    ...["repeat|Repeats|1|40|1", "thickness_nm|Thickness|1|600|1", "films|Films|1|40|1", "film_nm|Film thickness|1|400|1"],
    ...["gap_nm|Gap thickness|1|400|1", ...layered],
  ],
  grating: [
    ...["period_nm|Period|400|5000|10", "grooves|Grooves|1|200|1|100", "depth_nm|Depth|10|400|1"],
    ...["land|Land|0|1|0.01|0.5", "azimuth_deg|Azimuth|0|90|1|0"],
  ],
  crystal: ["diameter_nm|Diameter|120|600|1", "planes|Planes|1|100|1|30", ...layered],
  scatter: [
    ...["radius_nm|Radius|1|300|1", "radius_spread|Spread|0|0.5|0.01|0"],
    ...["volume_fraction|Volume share|1e-6|0.6|0.01", "thickness_um|Thickness|0.1|1e6|1"],
  ],
  measured: facets,
};
const indices: Record<string, string> = {
  ...{ incident: "In front", index: "Index", film: "Film", gap: "Gap", substrate: "Substrate" },
  ...{ sphere: "Spheres", medium: "Medium", particle: "Particles", coat: "Coat" },
};
// An index that is a table or a list, and one that the scene does not say.
const unnamed = ["as in the text", "default"];
const period = "{ index = 1.7, thickness_nm = 78 }, { index = 1.6, thickness_nm = 83 }";
const starts: Record<string, string> = {
  palette: `picks = [
    { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1.0 },
    { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 },\n]`,
  film: 'index = "water"\nthickness_nm = 400\nsubstrate = 1',
  stack: `layers = [\n    { repeat = 8, layers = [ ${period} ] },\n]\nsubstrate = 1.5`,
  grating: 'period_nm = 1600\ngrooves = 40\ndepth_nm = 175\nland = 0.69\ncoat = "al"',
  crystal: 'sphere = 1.46\nmedium = "water"\ndiameter_nm = 260\nplanes = 40\nsubstrate = 1.43',
  scatter: `model = "quasi_ordered"\nparticle = 1\nmedium = "keratin"\nradius_nm = 75\nradius_spread = 0.08
volume_fraction = 0.45\nthickness_um = 3`,
};

export class MechanismsPanel {
  private readonly tabs = new Map<string, HTMLButtonElement>();
  private rows: Row[] = [];
  private shape = "";
  /** A tab that the scene has no material for. */
  private offered = "";

  constructor(private readonly page: NacrePage) {
    for (const name of Object.keys(keys)) {
      const keydown = (event: KeyboardEvent): void => this.walk(name, event.key);
      const attributes = { role: "tab", id: `tab-${name}`, "aria-controls": "mechanism-panel" };
      this.tabs.set(name, el("button", { ...attributes, click: () => this.choose(name), keydown }, name));
    }
    byId("mechanisms").append(...this.tabs.values());
  }

  show(): void {
    const { material, doc } = this.page;
    const shown = this.offered || (material?.mechanism ?? "palette");
    const hasMeasured = doc.scene.materials.some(({ mechanism }) => mechanism === "measured");
    this.tabs.get("measured")!.hidden = !hasMeasured;
    for (const [name, tab] of this.tabs) {
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
    const word = mechanism === "palette" ? "" : `mechanism = "${mechanism}"\n`;
    const text = `nacre = 1\n\n[material.${mechanism}]\n${word}${starts[mechanism]}\n`;
    byId("mechanism-offer").replaceChildren(
      el("p", {}, `This scene has no ${mechanism}.`),
      el("button", { class: "primary", click: () => this.page.open(mechanism, text) }, `Start a ${mechanism}`),
      el("p", { class: "note" }, "It replaces the scene. Undo brings it back."),
    );
    this.show();
  }

  private walk(from: string, key: string): void {
    const way = { ArrowRight: 1, ArrowLeft: -1 }[key];
    if (way === undefined) return;
    const names = [...this.tabs.keys()].filter((name) => !this.tabs.get(name)!.hidden);
    const next = names.at((names.indexOf(from) + way) % names.length)!;
    this.choose(next);
    this.tabs.get(next)!.focus();
  }

  // The controls are made anew when the scene has other numbers, and keep the focus when it has only other values.
  private showControls(material: Material): void {
    const { values } = this.page.doc.scene;
    const { mechanism } = material;
    const root = `${materialPath(material)}.`;
    const order = (path: string): number => values[path]!.place.line * 1e4 + values[path]!.place.column;
    const given = Object.keys(values).filter((path) => path.startsWith(root)).sort((a, b) => order(a) - order(b));
    const shape = [mechanism, ...given.map((path) => path + typeof values[path]!.value)].join();
    if (shape !== this.shape) {
      this.shape = shape;
      const paths = [...given, ...this.standards(mechanism, root, given)];
      this.rows = paths.flatMap((path) => this.rowOf(path, root, mechanism));
      byId("mechanism-controls").replaceChildren(...this.rows.map(({ element }) => element));
    }
    for (const row of this.rows) row.show();
  }

  // What the scene leaves to nacre's defaults. Tilt and roughness exclude each other.
  private standards(mechanism: string, root: string, given: string[]): string[] {
    const isGiven = (spec: string): boolean => given.some((path) => path.startsWith(root + spec.split("|")[0]));
    const hasFacets = facets.some(isGiven);
    const left = keys[mechanism]!.filter((spec) => spec.split("|")[5] && !(hasFacets && facets.includes(spec)));
    const specs = [...(["film", "stack", "crystal"].includes(mechanism) ? ["substrate"] : []), ...left];
    return specs.filter((spec) => !isGiven(spec)).map((spec) => root + spec.split("|")[0]);
  }

  private rowOf(path: string, root: string, mechanism: string): Row[] {
    const inside = path.slice(root.length);
    const end = inside.slice(inside.lastIndexOf(".") + 1);
    if (inside !== end && !inside.startsWith("layers[")) return [];
    const layer = [...inside.matchAll(/layers\[(\d+)\]/g)].map((match) => Number(match[1]) + 1).join(".");
    const found = keys[mechanism]!.find((spec) => spec.startsWith(`${end}|`))?.split("|");
    const value = this.page.doc.scene.values[path];
    if (found && (!value || typeof value.value === "number")) {
      const [from, to, step, standard] = found.slice(2).map(Number) as [number, number, number, number?];
      const unit = { nm: "nm", um: "µm", deg: "°" }[/_(nm|um|deg)$/.exec(end)?.[1] ?? ""] ?? "";
      const spec = { label: `${layer} ${found[1]}`.trim(), unit, from, to, step };
      return [this.numberRow(path, { ...spec, isLogarithmic: from > 0 && to / from > 1e4 }, standard)];
    }
    return indices[end] ? [this.indexRow(path, `${layer} ${indices[end]}`.trim())] : [];
  }

  private numberRow(path: string, spec: NumberSpec, standard?: number): Row {
    const { doc } = this.page;
    const control = new NumberControl(spec, (value, gesture) => doc.set({ [path]: value }, gesture));
    const show = (): void => control.show((doc.value(path) as number | undefined) ?? standard, doc.has(path));
    return { element: control.element, show };
  }

  // A number, or the name of a shipped material.
  private indexRow(path: string, label: string): Row {
    const { doc, here } = this.page;
    const spec = { label, from: 1, to: 4, step: 0.01 };
    const control = new NumberControl(spec, (value, gesture) => doc.set({ [path]: value }, gesture));
    const change = (): void => {
      if (!unnamed.includes(select.value)) doc.set({ [path]: select.value === "" ? 1.5 : select.value });
    };
    const option = (value: string, title = ""): Node => el("option", { value, title }, value || "number");
    const named = here.shippedMaterials().map(({ name, about }) => option(name, about));
    const select = el("select", { "aria-label": `${label}: material`, change }, option(""), ...named);
    control.element.lastElementChild!.replaceWith(select);
    const show = (): void => {
      const value = doc.value(path);
      const name = typeof value === "number" ? "" : String(value ?? unnamed[doc.has(path) ? 0 : 1]);
      if (![...select.options].some((one) => one.value === name)) select.append(option(name));
      select.value = name;
      control.element.className = name === "" ? "number index" : "number index named";
      if (typeof value === "number") control.show(value);
    };
    return { element: control.element, show };
  }
}
