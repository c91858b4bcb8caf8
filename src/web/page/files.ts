// In and out: the gallery of shipped scenes, opening, dropping and saving, and what one leaves with.

import type { BakedLut } from "./api";
import { inAddress } from "./document";
import { byId, el } from "./dom";
import type { NacrePage } from "./main";
import { paintStrip } from "./strip";

function download(name: string, part: BlobPart, type: string): void {
  const href = URL.createObjectURL(new Blob([part], { type }));
  el("a", { href, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(href), 1000);
}

/** A LUT as a picture of a size that programs show: its colours over even degrees, rows as they are. */
function stripPicture(lut: BakedLut): HTMLCanvasElement {
  const [row, picture] = [el("canvas", {}), el("canvas", { width: 1024, height: Math.max(128, lut.height) })];
  paintStrip(row, lut, picture.width);
  const context = picture.getContext("2d")!;
  context.imageSmoothingEnabled = false;
  context.drawImage(row, 0, 0, picture.width, picture.height);
  return picture;
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
      void this.take([...event.dataTransfer!.files]);
    });
  }

  private save(): void {
    const { scene, text } = this.page.doc;
    download(`${scene.materials[0]?.name ?? "scene"}.toml`, text, "application/toml");
  }

  // Scenes replace the text; tables and materials are put beside it, where the scene may name them.
  private async take(files: File[]): Promise<void> {
    const isScene = ({ name }: File): boolean => /\.toml$/i.test(name);
    let said = "";
    for (const file of files.filter((one) => !isScene(one))) {
      const isTable = /\.(csv|ya?ml)$/i.test(file.name);
      said = `${file.name} is no scene (.toml), table (.csv) or material (.yml)`;
      if (!isTable) continue;
      const bytes = new Uint8Array(await file.arrayBuffer());
      this.page.here.putFile(file.name, bytes);
      this.page.worker.putFile(file.name, bytes).catch(() => undefined);
      said = `${file.name} lies beside the scene now; name it in the text: "${file.name}"`;
    }
    const scene = files.find(isScene);
    if (scene) this.page.open(scene.name, await scene.text());
    else this.page.doc.read();
    if (said !== "" && this.page.doc.opened.mistakes.length === 0) this.page.say(said);
  }

  private gallery(): void {
    const canvases = this.page.here.shippedScenes().map(({ name, title, text }) => {
      const canvas = el("canvas", { width: 160, height: 1, "aria-hidden": "true" });
      const choose = (): void => {
        byId("gallery").hidePopover();
        this.page.open(name, text);
      };
      byId("gallery").append(el("button", { class: "scene", click: choose, title }, canvas, name.replaceAll("_", " ")));
      return canvas;
    });
    byId("gallery").addEventListener("toggle", () => void this.paintThumbnails(canvases));
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
    const give = (part: string | Uint8Array | Blob, end: string, type: string): void =>
      download(`${page.lut?.name}.${end}`, part as BlobPart, type);
    const address = location.href.replace(/#.*/, "");
    const actions: Record<string, () => Promise<void> | void> = {
      "Texture (EXR)": async () => give(await page.asked((nacre, lut) => nacre.exr(lut)), "exr", "image/x-exr"),
      "Manifest (JSON)": async () => give(await page.asked((nacre, lut) => nacre.manifest(lut)), "json", "text/json"),
      "Strip (PNG)": () => stripPicture(page.baked!).toBlob((blob) => give(blob!, "png", "image/png")),
      "Scene (TOML)": () => this.save(),
      "Copy snippet (GLSL)": () => this.copy(page.here.snippet("glsl"), "nacre.glsl"),
      "Copy snippet (HLSL)": () => this.copy(page.here.snippet("hlsl"), "nacre.hlsl"),
      "Copy link": async () => this.copy(`${address}#${await inAddress(page.doc.text)}`, "link"),
    };
    for (const [name, action] of Object.entries(actions)) {
      const run = async (): Promise<void> => {
        byId("exports").hidePopover();
        await Promise.resolve(action()).catch((failure: Error) => page.say(failure.message));
      };
      byId("exports").append(el("button", { click: () => void run() }, name));
    }
  }

  private async copy(text: string, what: string): Promise<void> {
    await navigator.clipboard.writeText(text);
    this.page.say(`${what} is copied`);
  }
}
