// A tab for each mechanism, with the main numbers of the selected material as sliders.

import type { Material } from "./api";
import { byId, el, NumberControl, type NumberSpec } from "./dom";
import { materialPath, type Page } from "./page";

/** A number of a material by the end of its path; `standard` is what nacre takes if the scene does not say it. */
interface Key extends NumberSpec {
  key: string;
  standard?: number;
}

const nm = (key: string, label: string, from: number, to: number, standard?: number): Key => ({
  ...{ key, label, unit: "nm", from, to, step: 1 },
  ...(standard === undefined ? {} : { standard }),
});
const count = (key: string, label: string, to: number, standard?: number): Key => ({
  ...{ key, label, from: 1, to, step: 1 },
  ...(standard === undefined ? {} : { standard }),
});
const share = (key: string, label: string, to: number, standard?: number): Key => ({
  ...{ key, label, from: 0, to, step: 0.01 },
  ...(standard === undefined ? {} : { standard }),
});

const facets: Key[] = [
  { key: "tilt_deg", label: "Tilt", unit: "°", from: 0, to: 60, step: 0.5, standard: 0 },
  share("roughness", "Roughness", 1, 0),
];
const layered: Key[] = [nm("thickness_spread_nm", "Spread", 0, 60, 0), ...facets, share("base", "Base", 1, 0)];
const keys: Record<string, Key[]> = {
  palette: facets,
  film: [nm("thickness_nm", "Thickness", 0, 1500), ...layered],
  stack: [
    count("repeat", "Repeats", 40),
    nm("thickness_nm", "Thickness", 1, 600),
    count("films", "Films", 40, 10),
    nm("film_nm", "Film", 1, 400),
    nm("gap_nm", "Gap", 1, 400),
    ...layered,
  ],
  grating: [
    { key: "period_nm", label: "Period", unit: "nm", from: 400, to: 5000, step: 10 },
    count("grooves", "Grooves", 200, 100),
    nm("depth_nm", "Depth", 10, 400),
    share("land", "Land", 1, 0.5),
    { key: "azimuth_deg", label: "Azimuth", unit: "°", from: 0, to: 90, step: 1, standard: 0 },
  ],
  crystal: [nm("diameter_nm", "Diameter", 120, 600), count("planes", "Planes", 100, 30), ...layered],
  scatter: [
    nm("radius_nm", "Radius", 1, 300),
    share("radius_spread", "Spread", 0.5, 0),
    { key: "volume_fraction", label: "Volume share", from: 1e-6, to: 0.6, step: 0.01, isLogarithmic: true },
    { key: "thickness_um", label: "Thickness", unit: "µm", from: 0.1, to: 1e6, step: 1, isLogarithmic: true },
  ],
  measured: facets,
};
const indices: Record<string, string> = {
  incident: "In front",
  index: "Index",
  film: "Film",
  gap: "Gap",
  substrate: "Substrate",
  sphere: "Spheres",
  medium: "Medium",
  particle: "Particles",
  coat: "Coat",
};
const alwaysShown: Record<string, string[]> = { film: ["index", "substrate"], stack: ["substrate"] };

const starts: Record<string, string> = {
  palette: `picks = [
    { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1.0 },
    { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 },
]`,
  film: `mechanism = "film"\nindex = "water"\nthickness_nm = 400`,
  stack: `mechanism = "stack"
layers = [
    { repeat = 8, layers = [ { index = 1.7, thickness_nm = 78 }, { index = 1.6, thickness_nm = 83 } ] },
]
substrate = "melanin"`,
  grating: `mechanism = "grating"\nperiod_nm = 1600\ndepth_nm = 175\nland = 0.69\ncoat = "al"\ngrooves = 40`,
  crystal: `mechanism = "crystal"\nsphere = 1.46\nmedium = "water"\ndiameter_nm = 260\nplanes = 40\nsubstrate = 1.43`,
  scatter: `mechanism = "scatter"\nmodel = "quasi_ordered"\nparticle = 1\nmedium = "keratin"\nradius_nm = 75
radius_spread = 0.08\nvolume_fraction = 0.45\nthickness_um = 3`,
};

export class MechanismsPanel {
  private readonly tabs = new Map<string, HTMLButtonElement>();
  private readonly panel = byId("mechanism-controls");
  private readonly offer = byId("mechanism-offer");
  private controls: { path: string; show: () => void }[] = [];
  private shape = "";
  /** A tab that the scene has no material for. */
  private offered = "";

  constructor(private readonly page: Page) {
    for (const name of Object.keys(keys)) {
      const tab = el("button", { role: "tab", click: () => this.choose(name), id: `tab-${name}` }, name);
      tab.setAttribute("aria-controls", "mechanism-panel");
      tab.addEventListener("keydown", (event) => this.walk(name, event.key));
      this.tabs.set(name, tab);
    }
    byId("mechanisms").append(...this.tabs.values());
  }

  show(): void {
    const { material, doc } = this.page;
    const own = material?.mechanism ?? "palette";
    const shown = this.offered || own;
    for (const [name, tab] of this.tabs) {
      tab.hidden = name === "measured" && !doc.scene.materials.some((one) => one.mechanism === name);
      tab.setAttribute("aria-selected", String(name === shown));
      tab.tabIndex = name === shown ? 0 : -1;
      tab.classList.toggle("absent", !doc.scene.materials.some((one) => one.mechanism === name));
    }
    byId("mechanism-panel").setAttribute("aria-labelledby", `tab-${shown}`);
    byId("picks").hidden = shown !== "palette" || this.offered !== "" || !material?.picks;
    this.panel.hidden = this.offered !== "";
    this.offer.hidden = this.offered === "";
    if (this.offered === "" && material) this.showControls(material);
  }

  /** Another scene: its own tab is shown. */
  reset(): void {
    this.offered = "";
  }

  private choose(mechanism: string): void {
    const { doc, material } = this.page;
    const names = doc.scene.materials.filter((one) => one.mechanism === mechanism).map((one) => one.name);
    const lut = doc.scene.luts.find((one) => names.includes(one.material));
    this.offered = lut || material?.mechanism === mechanism ? "" : mechanism;
    if (lut && material?.mechanism !== mechanism) this.page.selectLut(lut.name);
    if (this.offered !== "") {
      const start = (): void => {
        this.page.anotherScene(mechanism);
        doc.replace(`nacre = 1\n\n[material.${mechanism}]\n${starts[mechanism]}\n`);
      };
      this.offer.replaceChildren(
        el("p", {}, `This scene has no ${mechanism}.`),
        el("button", { class: "primary", click: start }, `Start a ${mechanism}`),
        el("p", { class: "note" }, "It replaces the scene. Undo brings it back."),
      );
    }
    this.show();
  }

  private walk(from: string, key: string): void {
    const names = [...this.tabs.keys()].filter((name) => !this.tabs.get(name)!.hidden);
    const way = key === "ArrowRight" ? 1 : key === "ArrowLeft" ? -1 : 0;
    if (way === 0) return;
    const next = names[(names.indexOf(from) + way + names.length) % names.length]!;
    this.choose(next);
    this.tabs.get(next)!.focus();
  }

  // The controls are made anew when the scene has other numbers, and keep the focus when it has only other values.
  private showControls(material: Material): void {
    const root = `${materialPath(material)}.`;
    const { values } = this.page.doc.scene;
    const place = (path: string): number => values[path]!.place.line * 1e4 + values[path]!.place.column;
    const given = Object.keys(values).filter((path) => path.startsWith(root));
    given.sort((a, b) => place(a) - place(b));
    const shape = `${material.mechanism} ${given.join()} ${given.map((path) => this.kind(path)).join()}`;
    if (shape !== this.shape) {
      this.shape = shape;
      const rows = this.rows(material, root, given);
      this.controls = rows.map(({ path, show }) => ({ path, show }));
      this.panel.replaceChildren(...rows.map(({ element }) => element));
    }
    for (const control of this.controls) control.show();
  }

  private kind(path: string): string {
    return typeof this.page.doc.value(path)?.value;
  }

  private rows(material: Material, root: string, given: string[]): { path: string; element: Node; show(): void }[] {
    const rows: { path: string; element: Node; show(): void }[] = [];
    const ends = (path: string, key: string): boolean => path === root + key || /^layers\[/.test(path.slice(root.length));
    const paths = [...given];
    for (const key of alwaysShown[material.mechanism] ?? []) if (!given.includes(root + key)) paths.push(root + key);
    for (const { key, standard } of keys[material.mechanism] ?? []) {
      if (standard === undefined || given.some((path) => path.startsWith(root + key))) continue;
      const isOfLamellae = key === "films" && !given.includes(`${root}form`);
      const isOtherFacets = facets.some((facet) => facet.key === key) && given.some((path) => facets.some((facet) => path === root + facet.key));
      if (!isOfLamellae && !isOtherFacets) paths.push(root + key);
    }
    for (const path of paths) {
      const end = path.slice(Math.max(path.lastIndexOf("."), 0) + 1);
      const key = (keys[material.mechanism] ?? []).find((one) => one.key === end && ends(path, end));
      if (key && this.kind(path) !== "string") rows.push(this.numberRow(path, root, key));
      else if (indices[end] && ends(path, end)) rows.push(this.indexRow(path, root, indices[end]!));
    }
    return rows;
  }

  // "layers[0].layers[1]" as "1.2 "
  private prefix(path: string, root: string): string {
    const numbers = [...path.slice(root.length).matchAll(/layers\[(\d+)\]/g)].map((match) => Number(match[1]) + 1);
    return numbers.length > 0 ? `${numbers.join(".")} ` : "";
  }

  private numberRow(path: string, root: string, key: Key): { path: string; element: Node; show(): void } {
    const label = this.prefix(path, root) + key.label;
    const control = new NumberControl({ ...key, label }, (value, gesture) =>
      this.page.doc.set({ [path]: value }, gesture),
    );
    const show = (): void => {
      const value = this.page.doc.number(path);
      control.show(value ?? key.standard, value !== undefined);
    };
    return { path, element: control.element, show };
  }

  private indexRow(path: string, root: string, name: string): { path: string; element: Node; show(): void } {
    const { doc, here } = this.page;
    const label = this.prefix(path, root) + name;
    const control = new NumberControl({ label, from: 1, to: 4, step: 0.01 }, (value, gesture) =>
      doc.set({ [path]: value }, gesture),
    );
    const select = el("select", { "aria-label": `${label}: material` });
    select.append(el("option", { value: "" }, "number"));
    for (const { name: one, about } of here.shippedMaterials()) {
      select.append(el("option", { value: one, title: about }, one));
    }
    const choose = (): void => doc.set({ [path]: select.value === "" ? 1.5 : select.value });
    select.addEventListener("change", choose);
    const element = el("div", { class: "index" }, control.element);
    control.element.querySelector(".unit")!.replaceWith(select);
    const show = (): void => {
      const value = doc.value(path)?.value;
      const isOther = (value === undefined && doc.value(path) !== undefined) || typeof value === "boolean";
      const isUnknown = typeof value === "string" && ![...select.options].some((option) => option.value === value);
      if (isUnknown) select.append(el("option", { value: String(value) }, String(value)));
      select.disabled = isOther;
      select.value = typeof value === "string" ? value : "";
      element.classList.toggle("named", typeof value === "string" || isOther);
      control.show(typeof value === "number" ? value : 1, value !== undefined);
    };
    return { path, element, show };
  }
}
