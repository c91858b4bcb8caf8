// In and out: the gallery of shipped scenes, opening, dropping and saving, and what one leaves with.

import { byId, el } from "./dom";
import { inAddress } from "./document";
import type { Page } from "./page";
import { drawStrip } from "./strip";

function download(name: string, parts: BlobPart[], type: string): void {
  const address = URL.createObjectURL(new Blob(parts, { type }));
  el("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

export class FilesPanel {
  private hasThumbnails = false;

  constructor(private readonly page: Page) {
    this.gallery();
    this.exports();
    const input = byId<HTMLInputElement>("open-input");
    byId("open").addEventListener("click", () => input.click());
    input.addEventListener("change", () => void this.take([...(input.files ?? [])]).then(() => (input.value = "")));
    byId("save").addEventListener("click", () => this.save());
    document.addEventListener("dragover", (event) => event.preventDefault());
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      void this.take([...(event.dataTransfer?.files ?? [])]);
    });
  }

  save(): void {
    download(`${this.page.doc.scene.materials[0]?.name ?? "scene"}.toml`, [this.page.doc.text], "application/toml");
  }

  // Scenes replace the text; tables and materials are put beside it, where the scene may name them.
  private async take(files: File[]): Promise<void> {
    for (const file of files.filter((one) => !one.name.endsWith(".toml"))) {
      const bytes = new Uint8Array(await file.arrayBuffer());
      this.page.here.putFile(file.name, bytes);
      void this.page.worker.putFile(file.name, bytes);
      this.page.say(`${file.name} lies beside the scene now; name it in the text: "${file.name}"`);
    }
    const scene = files.find((one) => one.name.endsWith(".toml"));
    if (scene) this.open(scene.name.replace(/\.toml$/, ""), await scene.text());
    else this.page.doc.reread();
  }

  private open(name: string, text: string): void {
    this.page.anotherScene(name);
    this.page.doc.replace(text);
  }

  private gallery(): void {
    const popover = byId("gallery");
    const scenes = this.page.here.shippedScenes();
    const canvases = scenes.map(() => el("canvas", { width: 160, height: 1, "aria-hidden": "true" }));
    popover.replaceChildren(
      ...scenes.map(({ name, title, text }, i) => {
        const choose = (): void => {
          popover.hidePopover();
          this.open(name, text);
        };
        const words = el("span", {}, name.replaceAll("_", " "));
        return el("button", { class: "scene", click: choose, title }, canvases[i]!, words);
      }),
    );
    popover.addEventListener("toggle", () => void this.drawThumbnails(canvases));
  }

  // In the worker's spare time; what it did not come to is drawn when the gallery is opened again.
  private async drawThumbnails(canvases: HTMLCanvasElement[]): Promise<void> {
    if (this.hasThumbnails) return;
    this.hasThumbnails = true;
    const { here, worker } = this.page;
    for (const [i, { text }] of here.shippedScenes().entries()) {
      if (canvases[i]!.dataset.drawn) continue;
      const lut = await this.page.inSpareTime(async () => {
        const opened = await worker.open(text);
        const first = opened.luts.find((one) => !one.y) ?? opened.luts[0];
        return first && worker.bake(first.name, true);
      });
      if (lut) {
        drawStrip(canvases[i]!, lut, 160);
        canvases[i]!.dataset.drawn = "yes";
      } else this.hasThumbnails = false;
    }
  }

  private exports(): void {
    const { page } = this;
    const copy = async (text: string, what: string): Promise<void> => {
      try {
        await navigator.clipboard.writeText(text);
        page.say(`${what} copied`);
      } catch {
        page.say(`The browser does not allow to copy; ${what} is downloaded instead`);
        download(`${what.replaceAll(" ", "_")}.txt`, [text], "text/plain");
      }
    };
    const lut = (): string => page.lut?.name ?? "lut";
    const actions: [string, () => Promise<void> | void][] = [
      ["Texture (EXR)", async () => download(`${lut()}.exr`, [(await page.asked((engine, name) => engine.exr(name))) as BlobPart], "image/x-exr")],
      ["Manifest (JSON)", async () => download(`${lut()}.json`, [await page.asked((engine, name) => engine.manifest(name))], "application/json")],
      ["Strip (PNG)", () => byId<HTMLCanvasElement>("strip-canvas").toBlob((blob) => this.savePng(blob))],
      ["Scene (TOML)", () => this.save()],
      ["Copy snippet (GLSL)", () => copy(page.here.snippet("glsl"), "nacre.glsl")],
      ["Copy snippet (HLSL)", () => copy(page.here.snippet("hlsl"), "nacre.hlsl")],
      ["Copy link", async () => copy(`${location.href.replace(/#.*/, "")}#${await inAddress(page.doc.text)}`, "link")],
    ];
    byId("exports").replaceChildren(
      ...actions.map(([name, action]) => {
        const run = async (): Promise<void> => {
          byId("exports").hidePopover();
          try {
            await action();
          } catch (failure) {
            page.say((failure as Error).message);
          }
        };
        return el("button", { click: () => void run() }, name);
      }),
    );
  }

  private savePng(blob: Blob | null): void {
    if (blob) download(`${this.page.lut?.name ?? "lut"}.png`, [blob], "image/png");
  }
}
