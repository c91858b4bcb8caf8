// In and out: the gallery of shipped scenes, opening, dropping and saving, and what one leaves with.

import { inAddress } from "./document";
import { byId, el } from "./dom";
import type { NacrePage } from "./main";
import { paintStrip } from "./strip";

function download(name: string, part: BlobPart, type: string): void {
  const address = URL.createObjectURL(new Blob([part], { type }));
  el("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

export class FilesPanel {
  private isPainting = false;

  constructor(private readonly page: NacrePage) {
    this.gallery();
    this.exports();
    const input = byId<HTMLInputElement>("open-input");
    byId("open").addEventListener("click", () => input.click());
    input.addEventListener("change", () => void this.take([...input.files!]).then(() => (input.value = "")));
    byId("save").addEventListener("click", () => this.save());
    document.addEventListener("dragover", (event) => event.preventDefault());
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      void this.take([...(event.dataTransfer?.files ?? [])]);
    });
  }

  private save(): void {
    const { scene, text } = this.page.doc;
    download(`${scene.materials[0]?.name ?? "scene"}.toml`, text, "application/toml");
  }

  // Scenes replace the text; tables and materials are put beside it, where the scene may name them.
  private async take(files: File[]): Promise<void> {
    for (const file of files.filter(({ name }) => !name.endsWith(".toml"))) {
      const bytes = new Uint8Array(await file.arrayBuffer());
      this.page.here.putFile(file.name, bytes);
      void this.page.worker.putFile(file.name, bytes);
      this.page.say(`${file.name} lies beside the scene now; name it in the text: "${file.name}"`);
    }
    const scene = files.find(({ name }) => name.endsWith(".toml"));
    if (scene) this.page.open(scene.name, await scene.text());
    else this.page.doc.read();
  }

  private gallery(): void {
    const popover = byId("gallery");
    const scenes = this.page.here.shippedScenes();
    const canvases = scenes.map(() => el("canvas", { width: 160, height: 1, "aria-hidden": "true" }));
    const buttons = scenes.map(({ name, title, text }, i) => {
      const choose = (): void => {
        popover.hidePopover();
        this.page.open(name, text);
      };
      return el("button", { class: "scene", click: choose, title }, canvases[i]!, name.replaceAll("_", " "));
    });
    popover.replaceChildren(...buttons);
    popover.addEventListener("toggle", () => void this.paintThumbnails(canvases));
  }

  // In the worker's spare time; what it did not come to is painted when the gallery is opened again.
  private async paintThumbnails(canvases: HTMLCanvasElement[]): Promise<void> {
    if (this.isPainting) return;
    this.isPainting = true;
    for (const [i, { text }] of this.page.here.shippedScenes().entries()) {
      if (canvases[i]!.dataset.painted) continue;
      const lut = await this.page.inSpareTime(async (worker) => {
        const { luts } = await worker.open(text);
        return worker.bake((luts.find((one) => !one.y) ?? luts[0]!).name, true);
      });
      if (!lut) continue;
      paintStrip(canvases[i]!, lut, 160);
      canvases[i]!.dataset.painted = "yes";
    }
    this.isPainting = false;
  }

  private exports(): void {
    const { page } = this;
    const name = (): string => page.lut?.name ?? "lut";
    const exr = async (): Promise<void> =>
      download(`${name()}.exr`, (await page.asked((engine, lut) => engine.exr(lut))) as BlobPart, "image/x-exr");
    const manifest = async (): Promise<void> =>
      download(`${name()}.json`, await page.asked((engine, lut) => engine.manifest(lut)), "application/json");
    const png = (): void =>
      byId<HTMLCanvasElement>("strip-canvas").toBlob((blob) => download(`${name()}.png`, blob!, "image/png"));
    const link = async (): Promise<void> =>
      this.copy(`${location.href.replace(/#.*/, "")}#${await inAddress(page.doc.text)}`, "link");
    const actions: [string, () => Promise<void> | void][] = [
      ["Texture (EXR)", exr],
      ["Manifest (JSON)", manifest],
      ["Strip (PNG)", png],
      ["Scene (TOML)", () => this.save()],
      ["Copy snippet (GLSL)", () => this.copy(page.here.snippet("glsl"), "nacre.glsl")],
      ["Copy snippet (HLSL)", () => this.copy(page.here.snippet("hlsl"), "nacre.hlsl")],
      ["Copy link", link],
    ];
    const run = async (action: () => Promise<void> | void): Promise<void> => {
      byId("exports").hidePopover();
      await Promise.resolve(action()).catch((failure: Error) => page.say(failure.message));
    };
    const buttons = actions.map(([words, action]) => el("button", { click: () => void run(action) }, words));
    byId("exports").replaceChildren(...buttons);
  }

  private async copy(text: string, what: string): Promise<void> {
    try {
      await navigator.clipboard.writeText(text);
      this.page.say(`${what} is copied`);
    } catch {
      this.page.say(`The browser does not let the page copy; ${what} is downloaded instead`);
      download(`${what}.txt`, text, "text/plain");
    }
  }
}
