// The page: reads the scene when its text has changed, bakes, and shows. The panels know each other only through this.

import type { AsyncEngine, BakedLut, Engine, LutSummary, Material } from "./api";
import { WorkerBakes, type BakeRequest } from "./baking";
import { fromAddress, inAddress, SceneDocument } from "./document";
import { byId } from "./dom";
import { EffectsPanel, SearchPanel } from "./effects";
import { startEngine } from "./engine";
import { FilesPanel } from "./files";
import { MechanismsPanel } from "./mechanisms";
import { OutputView } from "./output";
import { OutputPanel } from "./output_panel";
import { PalettePanel } from "./palette";
import { PlanePanel } from "./plane";
import { StripPanel } from "./strip";
import { TextPanel } from "./text";

// LUTs of palettes and films that take less time than this are baked on the page's own thread, within a frame.
const frameSeconds = 0.02;
const addressMs = 400;
const spareMs = 50;

export class NacrePage {
  readonly doc: SceneDocument;
  readonly view: OutputView;
  /** The LUT that is shown, its material, and the pick of it that is selected. */
  lut: LutSummary | undefined;
  material: Material | undefined;
  pick = 0;
  baked: BakedLut | undefined;
  /** Whether `baked` is a quick answer. */
  isCoarse = false;
  /** From the change of the text to the picture, without the wait for the frame; of the worker, to its exact answer. */
  lastUpdateMs = 0;

  private readonly mechanisms = new MechanismsPanel(this);
  private readonly search = new SearchPanel(this);
  private readonly text = new TextPanel(this);
  private readonly ofScene = [this.mechanisms, new PlanePanel(this), new PalettePanel(this), this.search, this.text];
  private readonly ofLut = [new StripPanel(this), new EffectsPanel(this)];
  private readonly output: OutputPanel;
  private readonly bakes: WorkerBakes;
  private isBakedHere = false;
  private isSpare = false;
  private frame = 0;
  private showMs = 0;
  private addressTimer = 0;
  private turn: Promise<unknown> = Promise.resolve();

  constructor(readonly here: Engine, readonly worker: AsyncEngine) {
    this.doc = new SceneDocument(here);
    this.doc.onChange = () => this.changed();
    this.view = new OutputView(byId<HTMLCanvasElement>("output-canvas"), here.snippet("glsl"));
    this.output = new OutputPanel(this.view);
    this.bakes = new WorkerBakes(
      worker,
      (request, baked, isCoarse) => this.answered(request, baked, isCoarse),
      (message) => [document.body.classList.remove("busy"), this.say(message)],
      () => !this.search.isSearching,
    );
    new FilesPanel(this);
    this.buttons();
  }

  /** Another scene, which is shown on an object that its name calls for. */
  open(name: string, text: string): void {
    this.lut = this.baked = undefined;
    this.pick = 0;
    this.mechanisms.reset();
    this.output.chooseFor(name);
    this.doc.replace(text);
  }

  selectPick(pick: number): void {
    if (pick === this.pick) return;
    this.pick = pick;
    for (const panel of [...this.ofScene, ...this.ofLut]) panel.show();
  }

  selectLut(name: string): void {
    this.lut = this.doc.scene.luts.find((lut) => lut.name === name);
    this.baked = undefined;
    this.mechanisms.reset();
    this.changed();
  }

  /** Says something in the status line, to screen readers too. */
  readonly say = (message: string): void => void (byId("status").textContent = message);

  /** Runs when the worker has nothing more urgent to do, one after the other. Nothing if it was cancelled or failed. */
  inSpareTime<Result>(work: (worker: AsyncEngine, lut: string) => Promise<Result>): Promise<Result | undefined> {
    const isBusy = (): boolean => this.bakes.isBusy || this.search.isSearching;
    const result = this.turn.then(async () => {
      while (isBusy()) await new Promise((resolve) => setTimeout(resolve, spareMs));
      this.isSpare = true;
      return this.askWorker(work).catch(() => undefined).finally(() => (this.isSpare = false));
    });
    this.turn = result;
    return result;
  }

  /** Asks whichever engine baked what is shown. */
  async asked<Result>(work: (engine: Engine | AsyncEngine, lut: string) => Result | Promise<Result>): Promise<Result> {
    if (this.isBakedHere) return work(this.here, this.lut!.name);
    return this.askWorker(async (worker, lut) => work(worker, lut));
  }

  private async askWorker<Result>(work: (worker: AsyncEngine, lut: string) => Promise<Result>): Promise<Result> {
    const [, result] = await Promise.all([this.worker.open(this.doc.goodText), work(this.worker, this.lut!.name)]);
    return result;
  }

  private changed(): void {
    const start = performance.now();
    const { scene, opened } = this.doc;
    this.lut = scene.luts.find((lut) => lut.name === this.lut?.name) ?? scene.luts[0];
    this.material = scene.materials.find((material) => material.name === this.lut?.material);
    this.pick = Math.min(this.pick, Math.max(0, (this.material?.picks?.length ?? 1) - 1));
    byId("scene-name").textContent = scene.materials[0]?.name.replaceAll("_", " ") ?? "scene";
    byId<HTMLButtonElement>("undo").disabled = !this.doc.canStep(-1);
    byId<HTMLButtonElement>("redo").disabled = !this.doc.canStep(1);
    document.body.classList.toggle("mistaken", opened.mistakes.length > 0);
    this.say(opened.mistakes[0]?.message ?? "");
    for (const panel of this.ofScene) panel.show();
    this.showMs = performance.now() - start;
    // A wrong text changes nothing that is shown; what was to be shown still is.
    if (opened.mistakes.length === 0) {
      cancelAnimationFrame(this.frame);
      this.frame = requestAnimationFrame(() => this.update());
    }
    clearTimeout(this.addressTimer);
    const keep = async (): Promise<void> => history.replaceState(null, "", `#${await inAddress(this.doc.text)}`);
    this.addressTimer = window.setTimeout(keep, addressMs);
  }

  private update(): void {
    if (!this.lut || !this.material) return;
    const startMs = performance.now() - this.doc.openMs - this.showMs;
    const { name, entry, quantity, y } = this.lut;
    const other = this.doc.scene.luts.filter((lut) => lut.entry === entry && lut.quantity !== quantity);
    const luts = [name, ...other.slice(0, 1).map((lut) => lut.name)];
    const isKnown = !this.isCoarse && this.baked?.name === name;
    const seconds = isKnown ? Object.values(this.baked!.seconds).reduce((sum, part) => sum + part, 0) : 0;
    this.isBakedHere = ["palette", "film"].includes(this.material.mechanism) && !y && seconds < frameSeconds;
    const request = { text: this.doc.goodText, luts, startMs };
    document.body.classList.toggle("busy", !this.isBakedHere);
    if (!this.isBakedHere && this.isSpare) this.worker.cancel();
    this.bakes.request(this.isBakedHere ? undefined : request);
    if (!this.isBakedHere) return;
    try {
      this.answered(request, luts.map((lut) => this.here.bake(lut)), false);
    } catch (failure) {
      this.say((failure as Error).message);
    }
  }

  private answered({ luts, startMs }: BakeRequest, [first, second]: BakedLut[], isCoarse: boolean): void {
    if (this.lut?.name !== luts[0]) return;
    const isFirstThrough = first!.quantity === "transmittance" && second !== undefined;
    this.baked = first;
    this.isCoarse = isCoarse;
    this.view.setLut((isFirstThrough ? second : first)!, isFirstThrough ? first : second);
    this.output.showAxis(first!.y);
    for (const panel of this.ofLut) panel.show();
    this.view.drawWhenFree();
    document.body.classList.toggle("busy", isCoarse);
    if (first!.warnings[0]) this.say(first!.warnings[0]);
    if (!isCoarse) this.lastUpdateMs = performance.now() - startMs;
  }

  private buttons(): void {
    byId("undo").addEventListener("click", () => this.doc.step(-1));
    byId("redo").addEventListener("click", () => this.doc.step(1));
    const { classList } = document.body;
    byId("text-toggle").addEventListener("click", () => this.foldText(!classList.contains("text-folded")));
    this.foldText(innerWidth < 1500);
    const { dataset } = document.documentElement;
    dataset.theme = matchMedia("(prefers-color-scheme: light)").matches ? "light" : "dark";
    byId("theme").addEventListener("click", () => (dataset.theme = dataset.theme === "dark" ? "light" : "dark"));
    addEventListener("hashchange", async () => {
      const text = await fromAddress(location.hash);
      if (text !== "" && text !== this.doc.text) this.open("", text);
    });
    addEventListener("keydown", (event) => {
      const key = event.key.toLowerCase();
      if (!(event.ctrlKey || event.metaKey) || event.altKey || !["z", "y"].includes(key)) return;
      this.doc.step(key === "y" || event.shiftKey ? 1 : -1);
      event.preventDefault();
    });
  }

  private foldText(isFolded: boolean): void {
    document.body.classList.toggle("text-folded", isFolded);
    byId("text-toggle").setAttribute("aria-expanded", String(!isFolded));
    this.text.show();
  }
}

async function start(): Promise<void> {
  const { here, worker } = await startEngine();
  const page = new NacrePage(here, worker);
  Object.assign(window, { nacrePage: page });
  const first = here.shippedScenes().find(({ name }) => name === "morpho")!;
  const linked = await fromAddress(location.hash);
  const isWrong = linked !== "" && here.open(linked).mistakes.length > 0;
  // A wrong text is shown over a scene that is right: there is always something to look at.
  if (linked === "" || isWrong) page.open(first.name, first.text);
  if (linked !== "" && !isWrong) page.open("", linked);
  if (isWrong) page.doc.replace(linked);
  if (linked === "" && location.hash !== "") page.say("The address holds no scene that can be read; this is the Morpho");
  document.body.classList.add("ready");
}

start().catch((failure: Error) => (byId("status").textContent = failure.message));
