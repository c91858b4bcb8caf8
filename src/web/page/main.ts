// The page: reads the scene when its text has changed, bakes, and shows. What all panels share is in page.ts.

import type { AsyncEngine, BakedLut, Engine, LutSummary, Material } from "./api";
import { WorkerBakes, type BakeRequest } from "./baking";
import { fromAddress, inAddress, SceneDocument } from "./document";
import { byId } from "./dom";
import { EffectsPanel, SearchPanel } from "./effects";
import { startEngine } from "./engine";
import { FilesPanel } from "./files";
import { MechanismsPanel } from "./mechanisms";
import { OutputView } from "./output";
import { objectFor, OutputPanel } from "./output_panel";
import type { Page } from "./page";
import { PalettePanel } from "./palette";
import { PlanePanel } from "./plane";
import { StripPanel } from "./strip";
import { TextPanel } from "./text";

// LUTs of palettes and films that take less time than this are baked on the page's own thread, within a frame.
const frameSeconds = 0.02;
const noTime = { deciding: 0, computing: 0, measuring: 0 };
const addressMs = 400;

class NacrePage implements Page {
  readonly doc: SceneDocument;
  readonly view: OutputView;
  lut: LutSummary | undefined;
  material: Material | undefined;
  pick = 0;
  baked: BakedLut | undefined;
  transmitted: BakedLut | undefined;
  isCoarse = false;
  /** From the change of the text to the picture, without the wait for the frame. */
  lastUpdateMs = 0;

  private readonly panels: { show(): void }[];
  private readonly mechanisms: MechanismsPanel;
  private readonly text: TextPanel;
  private readonly output: OutputPanel;
  private readonly bakes: WorkerBakes;
  private readonly search: SearchPanel;
  private isBakedHere = false;
  private frame = 0;
  private showMs = 0;
  private addressTimer = 0;
  private inTurn: Promise<unknown> = Promise.resolve();

  constructor(
    readonly here: Engine,
    readonly worker: AsyncEngine,
  ) {
    this.doc = new SceneDocument(here);
    this.view = new OutputView(byId<HTMLCanvasElement>("output-canvas"), here.snippet("glsl"));
    this.output = new OutputPanel(this.view);
    this.text = new TextPanel(this);
    this.mechanisms = new MechanismsPanel(this);
    this.search = new SearchPanel(this);
    const palette = new PalettePanel(this);
    this.panels = [this.mechanisms, new PlanePanel(this), palette, this.search, this.text];
    this.afterBake = [new StripPanel(this), new EffectsPanel(this), this.text];
    this.bakes = new WorkerBakes(
      worker,
      (request, baked, isCoarse) => this.answered(request, baked, isCoarse),
      (message) => this.say(message === "cancelled" ? "" : message),
      () => !this.search.isSearching,
    );
    new FilesPanel(this);
    this.doc.onChange = () => this.changed();
    this.buttons();
  }

  private readonly afterBake: { show(): void }[];

  selectPick(pick: number): void {
    if (pick === this.pick) return;
    this.pick = pick;
    for (const panel of [...this.panels, ...this.afterBake]) panel.show();
  }

  selectLut(name: string): void {
    this.lut = this.doc.scene.luts.find((lut) => lut.name === name);
    this.baked = undefined;
    this.mechanisms.reset();
    this.changed();
  }

  say(message: string): void {
    byId("status").textContent = message;
  }

  async inSpareTime<Result>(work: () => Promise<Result>): Promise<Result | undefined> {
    const turn = this.inTurn.then(async () => {
      while (this.bakes.isBusy || this.search.isSearching) {
        await this.bakes.whenIdle();
        if (this.search.isSearching) await new Promise((resolve) => setTimeout(resolve, 200));
      }
      return work().catch(() => undefined);
    });
    this.inTurn = turn;
    return turn;
  }

  async asked<Result>(work: (engine: Engine | AsyncEngine, lut: string) => Result | Promise<Result>): Promise<Result> {
    if (this.isBakedHere) return work(this.here, this.lut?.name ?? "");
    return this.inWorker((worker, lut) => Promise.resolve(work(worker, lut)));
  }

  async inWorker<Result>(work: (worker: AsyncEngine, lut: string) => Promise<Result>): Promise<Result> {
    const opening = this.worker.open(this.doc.text);
    const result = work(this.worker, this.lut?.name ?? "");
    await opening;
    return result;
  }

  /** A scene from the gallery, a file or the address: its own object and its own first LUT. */
  anotherScene(name: string): void {
    this.lut = undefined;
    this.pick = 0;
    this.baked = undefined;
    this.mechanisms.reset();
    this.output.choose(objectFor(name));
  }

  private changed(): void {
    const start = performance.now();
    const { scene, opened } = this.doc;
    this.lut = scene.luts.find((lut) => lut.name === this.lut?.name) ?? scene.luts[0];
    this.material = scene.materials.find((material) => material.name === this.lut?.material);
    this.pick = Math.min(this.pick, Math.max(0, (this.material?.picks?.length ?? 1) - 1));
    byId("scene-name").textContent = scene.materials[0]?.name.replaceAll("_", " ") ?? "scene";
    document.body.classList.toggle("mistaken", opened.mistakes.length > 0);
    byId<HTMLButtonElement>("undo").disabled = !this.doc.canUndo;
    byId<HTMLButtonElement>("redo").disabled = !this.doc.canRedo;
    for (const panel of this.panels) panel.show();
    this.say(opened.mistakes[0]?.message.split("\n")[0] ?? "");
    this.showMs = performance.now() - start;
    if (opened.mistakes.length === 0) {
      cancelAnimationFrame(this.frame);
      this.frame = requestAnimationFrame(() => this.update());
    }
    clearTimeout(this.addressTimer);
    this.addressTimer = window.setTimeout(() => void this.keepInAddress(), addressMs);
  }

  private update(): void {
    if (!this.lut || !this.material) return;
    const pair = this.doc.scene.luts.filter((lut) => lut.entry === this.lut!.entry && lut !== this.lut);
    const luts = [this.lut, ...pair.filter((lut) => lut.quantity !== this.lut!.quantity)].map((lut) => lut.name);
    const start = performance.now();
    const isKnown = !this.isCoarse && this.baked?.name === this.lut.name;
    const { deciding, computing, measuring } = (isKnown && this.baked?.seconds) || noTime;
    const isLight = ["palette", "film"].includes(this.material.mechanism) && !this.lut.y;
    this.isBakedHere = isLight && deciding + computing + measuring < frameSeconds;
    if (!this.isBakedHere) {
      document.body.classList.add("busy");
      this.bakes.request({ text: this.doc.text, luts });
      return;
    }
    try {
      this.bakes.forget();
      this.shown(luts.map((lut) => this.here.bake(lut)), false);
    } catch (failure) {
      this.say((failure as Error).message);
    }
    this.lastUpdateMs = this.doc.openMs + this.showMs + performance.now() - start;
  }

  private answered(request: BakeRequest, baked: BakedLut[], isCoarse: boolean): void {
    if (this.doc.scene.luts.some((lut) => lut.name === request.luts[0]) && this.lut?.name === request.luts[0]) {
      this.shown(baked, isCoarse);
    }
  }

  private shown(baked: BakedLut[], isCoarse: boolean): void {
    const [first, second] = baked;
    const isFirstThrough = first!.quantity === "transmittance" && second !== undefined;
    this.baked = first;
    this.transmitted = isFirstThrough ? first : second;
    this.isCoarse = isCoarse;
    this.view.setLut((isFirstThrough ? second : first) ?? null, this.transmitted);
    for (const panel of this.afterBake) panel.show();
    this.view.draw();
    document.body.classList.toggle("busy", isCoarse);
  }

  private async keepInAddress(): Promise<void> {
    const hash = `#${await inAddress(this.doc.text)}`;
    if (hash !== location.hash) history.replaceState(null, "", hash);
  }

  private buttons(): void {
    byId("undo").addEventListener("click", () => this.doc.step(-1));
    byId("redo").addEventListener("click", () => this.doc.step(1));
    byId("text-toggle").addEventListener("click", () => this.foldText(!document.body.classList.contains("text-folded")));
    this.foldText(innerWidth < 1500);
    byId("theme").addEventListener("click", () => {
      const isDark = document.documentElement.dataset.theme === "dark";
      document.documentElement.dataset.theme = isDark ? "light" : "dark";
    });
    document.documentElement.dataset.theme = matchMedia("(prefers-color-scheme: light)").matches ? "light" : "dark";
    addEventListener("hashchange", () => void fromAddress(location.hash).then((text) => text && this.doc.replace(text)));
    addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
      const key = event.key.toLowerCase();
      if (key === "z" || key === "y") this.doc.step(key === "y" || event.shiftKey ? 1 : -1);
      else return;
      event.preventDefault();
    });
  }

  private foldText(isFolded: boolean): void {
    document.body.classList.toggle("text-folded", isFolded);
    byId("text-toggle").setAttribute("aria-expanded", String(!isFolded));
  }
}

async function start(): Promise<void> {
  const { here, worker } = await startEngine();
  const page = new NacrePage(here, worker);
  (window as unknown as { nacrePage: NacrePage }).nacrePage = page;
  const scenes = here.shippedScenes();
  const first = scenes.find((scene) => scene.name === "morpho") ?? scenes[0]!;
  const linked = await fromAddress(location.hash);
  page.anotherScene(linked === undefined ? first.name : "scene");
  page.doc.replace(linked ?? first.text);
  document.body.classList.add("ready");
}

void start().catch((failure: Error) => (byId("status").textContent = failure.message));
