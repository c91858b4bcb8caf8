// The effects of the shown LUT with a switch each, and the search for a structure that shows the picks of a palette.

import { byId, el, short } from "./dom";
import type { Page } from "./page";

export class EffectsPanel {
  constructor(private readonly page: Page) {}

  show(): void {
    const { baked, doc } = this.page;
    const effects = [...(baked?.effects ?? [])].sort((a, b) => b.contribution - a.contribution);
    const path = "accuracy.without";
    const left: string[] = [];
    for (let i = 0; doc.value(`${path}[${i}]`); ++i) left.push(String(doc.value(`${path}[${i}]`)!.value));
    byId("effects-section").hidden = effects.length === 0;
    const most = Math.max(1, ...effects.map((effect) => effect.contribution));
    byId("effects").replaceChildren(
      ...effects.map((effect) => {
        const isLeft = left.includes(effect.name);
        const box = el("input", { type: "checkbox", role: "switch", checked: !isLeft });
        box.addEventListener("change", () => {
          const others = left.filter((name) => name !== effect.name);
          doc.set({ [path]: box.checked ? others : [...others, effect.name] });
        });
        const size = `${Math.min(100, (100 * Math.log1p(effect.contribution)) / Math.log1p(most))}%`;
        const why = isLeft ? "left out" : effect.isSimulated ? "simulated" : "too small to matter";
        return el(
          "label",
          { class: effect.isSimulated ? "effect" : "effect idle", title: `Needed above ΔE00 ${short(effect.share)}` },
          el("span", { class: "bar", style: `width:${size}` }),
          box,
          el("span", { class: "name" }, effect.name.replaceAll("_", " ")),
          el("span", { class: "note" }, why),
          el("span", { class: "value" }, `ΔE00 ${short(effect.contribution, 2)}`),
        );
      }),
    );
  }
}

export class SearchPanel {
  isSearching = false;
  private readonly start = byId<HTMLButtonElement>("search-start");
  private readonly progress = byId<HTMLProgressElement>("search-progress");
  private readonly result = byId("search-result");

  constructor(private readonly page: Page) {
    this.start.addEventListener("click", () => (this.isSearching ? page.worker.cancel() : void this.search()));
  }

  show(): void {
    byId("search-section").hidden = !this.page.material?.picks;
  }

  private async search(): Promise<void> {
    const mechanism = byId<HTMLSelectElement>("search-mechanism").value;
    const { doc, worker, material } = this.page;
    this.mark(true);
    this.result.replaceChildren();
    const start = performance.now();
    try {
      void worker.open(doc.text).catch(() => undefined);
      const found = await worker.findStructure(material!.name, mechanism, (done) => {
        const seconds = short((performance.now() - start) / 1000, 2);
        this.progress.title = `${done} steps`;
        byId("search-time").textContent = `${seconds} s`;
      });
      const take = (): void => {
        this.result.replaceChildren();
        doc.replace(found.text);
      };
      this.result.replaceChildren(
        el("p", {}, found.summary),
        el("button", { class: "primary", click: take }, `Use this ${mechanism}`),
      );
      this.result.scrollIntoView({ block: "nearest" });
    } catch (failure) {
      this.result.replaceChildren(el("p", { class: "note" }, (failure as Error).message));
    }
    this.mark(false);
  }

  private mark(isSearching: boolean): void {
    this.isSearching = isSearching;
    this.start.textContent = isSearching ? "Cancel" : "Search";
    this.progress.hidden = !isSearching;
    byId("search-time").textContent = "";
  }
}
