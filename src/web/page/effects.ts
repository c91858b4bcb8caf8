// The effects of the shown LUT with a switch each, and the search for a structure that shows the picks of a palette.

import type { EffectChoice } from "./api";
import { byId, el, short } from "./dom";
import type { NacrePage } from "./main";

export class EffectsPanel {
  constructor(private readonly page: NacrePage) {}

  show(): void {
    const effects = [...(this.page.baked?.effects ?? [])].sort((a, b) => b.contribution - a.contribution);
    const without: string[] = [];
    for (let i = 0; this.page.doc.has(`accuracy.without[${i}]`); ++i) {
      without.push(String(this.page.doc.value(`accuracy.without[${i}]`)));
    }
    const most = Math.max(1, ...effects.map((effect) => effect.contribution));
    byId("effects-section").hidden = effects.length === 0;
    byId("effects").replaceChildren(...effects.map((effect) => this.row(effect, without, most)));
  }

  private row({ name, isSimulated, contribution, share }: EffectChoice, without: string[], most: number): Node {
    const isLeft = without.includes(name);
    const others = without.filter((other) => other !== name);
    const flip = (): void => this.page.doc.set({ "accuracy.without": isLeft ? others : [...without, name] });
    const why = isLeft ? "left out" : isSimulated ? "simulated" : "too small to matter";
    return el(
      "label",
      { class: isSimulated ? "effect" : "effect idle", title: `Needed above ΔE00 ${short(share)}` },
      el("span", { class: "bar", style: `width:${(100 * Math.log1p(contribution)) / Math.log1p(most)}%` }),
      el("input", { type: "checkbox", role: "switch", checked: !isLeft, change: flip }),
      el("span", { class: "name" }, name.replaceAll("_", " ")),
      el("span", { class: "note" }, why),
      el("span", { class: "value" }, `ΔE00 ${short(contribution, 2)}`),
    );
  }
}

export class SearchPanel {
  isSearching = false;
  private readonly result = byId("search-result");

  constructor(private readonly page: NacrePage) {
    byId("search-start").addEventListener("click", () => {
      if (this.isSearching) page.worker.cancel();
      else void this.search(byId<HTMLSelectElement>("search-mechanism").value);
    });
  }

  show(): void {
    byId("search-section").hidden = !this.page.material?.picks;
  }

  private async search(mechanism: string): Promise<void> {
    const { doc, worker, material } = this.page;
    this.mark(true);
    const start = performance.now();
    const step = (): void => {
      byId("search-time").textContent = `${short((performance.now() - start) / 1000, 2)} s`;
    };
    try {
      const opening = worker.open(doc.text);
      const [found] = await Promise.all([worker.findStructure(material!.name, mechanism, step), opening]);
      const take = (): void => {
        this.result.replaceChildren();
        doc.replace(found.text);
      };
      const taker = el("button", { class: "primary", click: take }, `Use this ${mechanism}`);
      this.result.replaceChildren(el("p", {}, found.summary), taker);
      taker.scrollIntoView({ block: "nearest" });
    } catch (failure) {
      this.result.replaceChildren(el("p", { class: "note" }, (failure as Error).message));
    }
    this.mark(false);
  }

  private mark(isSearching: boolean): void {
    this.isSearching = isSearching;
    if (isSearching) this.result.replaceChildren();
    byId("search-start").textContent = isSearching ? "Cancel" : "Search";
    byId("search-progress").hidden = !isSearching;
    byId("search-time").textContent = "";
  }
}
