// The effects of the shown LUT with a switch each, and the search for a structure that shows the picks of a palette.

import type { EffectChoice } from "./api";
import { byId, el, short } from "./dom";
import type { NacrePage } from "./main";

export class EffectsPanel {
  constructor(private readonly page: NacrePage) {}

  show(): void {
    const { doc, baked } = this.page;
    const effects = [...(baked?.effects ?? [])].sort((a, b) => b.contribution - a.contribution);
    const without: string[] = [];
    while (doc.has(`accuracy.without[${without.length}]`)) {
      without.push(String(doc.value(`accuracy.without[${without.length}]`)));
    }
    const most = Math.max(1, ...effects.map((effect) => effect.contribution));
    byId("effects-section").hidden = effects.length === 0;
    byId("effects").replaceChildren(...effects.map((effect) => this.row(effect, without, most)));
  }

  private row({ name, isSimulated, contribution, share }: EffectChoice, without: string[], most: number): Node {
    const isLeft = without.includes(name);
    const other = isLeft ? without.filter((one) => one !== name) : [...without, name];
    const change = (): void => this.page.doc.set({ "accuracy.without": other });
    const why = isLeft ? "left out" : isSimulated ? "simulated" : "too small to matter";
    const size = `width:${(100 * Math.log1p(contribution)) / Math.log1p(most)}%`;
    const title = `Needed above ΔE00 ${short(share)}`;
    return el(
      ...(["label", { class: isSimulated ? "effect" : "effect idle", title }] as const),
      el("span", { class: "bar", style: size }),
      el("input", { type: "checkbox", role: "switch", checked: !isLeft, change }),
      el("span", { class: "name" }, name.replaceAll("_", " ")),
      el("span", { class: "note" }, why),
      el("span", { class: "value" }, `ΔE00 ${short(contribution, 2)}`),
    );
  }
}

export class SearchPanel {
  isSearching = false;

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
    const seconds = (): string => short((performance.now() - start) / 1000, 2);
    const step = (): void => void (byId("search-time").textContent = `${seconds()} s`);
    try {
      const opening = worker.open(doc.goodText);
      const [found] = await Promise.all([worker.findStructure(material!.name, mechanism, step), opening]);
      this.mark(false, el("p", {}, found.summary), el("button", { class: "primary" }, `Use this ${mechanism}`));
      const taker = byId("search-result").querySelector("button")!;
      taker.scrollIntoView({ block: "nearest" });
      taker.addEventListener("click", () => {
        this.mark(false);
        doc.replace(found.text);
      });
    } catch (failure) {
      this.mark(false, el("p", { class: "note" }, (failure as Error).message));
    }
  }

  private mark(isSearching: boolean, ...result: Node[]): void {
    this.isSearching = isSearching;
    byId("search-result").replaceChildren(...result);
    byId("search-start").textContent = isSearching ? "Cancel" : "Search";
    byId("search-progress").hidden = !isSearching;
    byId("search-time").textContent = "";
  }
}
