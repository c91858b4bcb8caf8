// nacre's module of WebAssembly, and Engine on top of it. Runs on the page's thread, in the worker and in Node.

import type { BakedLut, CostPoint, Engine, Listed, OpenedScene, Pick } from "./api";
import { parseYaml } from "./yaml";

/** What Emscripten's loader makes: see exports.cpp. */
export interface NacreModule {
  _malloc(size: number): number;
  _free(address: number): void;
  _nacre_call(name: number, argumentsJson: number): number;
  _nacre_bytes(): number;
  _nacre_byte_count(): number;
  _nacre_put_file(path: number, bytes: number, count: number): number;
  HEAPU8: Uint8Array;
  UTF8ToString(address: number): string;
  stringToUTF8(text: string, address: number, size: number): void;
  lengthBytesUTF8(text: string): number;
  step?: (done: number) => void;
}

export type CreateNacre = (options: { wasmBinary: Uint8Array; parseYaml: typeof parseYaml }) => Promise<NacreModule>;

/** A shipped scene, and the files that it names. */
export interface ShippedScene {
  name: string;
  title: string;
  text: string;
  files: Record<string, string>;
}

export async function makeEngine(
  create: CreateNacre,
  wasm: Uint8Array,
  scenes: ShippedScene[],
): Promise<ModuleEngine> {
  return new ModuleEngine(await create({ wasmBinary: wasm, parseYaml }), scenes);
}

export class ModuleEngine implements Engine {
  constructor(
    private readonly module: NacreModule,
    private readonly scenes: ShippedScene[],
  ) {
    const encoder = new TextEncoder();
    for (const scene of scenes) {
      for (const [name, text] of Object.entries(scene.files)) this.putFile(name, encoder.encode(text));
    }
  }

  version(): string {
    return this.call("version");
  }

  putFile(path: string, bytes: Uint8Array): void {
    const module = this.module;
    const address = module._malloc(bytes.length || 1);
    module.HEAPU8.set(bytes, address);
    const isWritten = this.withText(path, (name) => module._nacre_put_file(name, address, bytes.length));
    module._free(address);
    if (!isWritten) throw new Error(`${path}: cannot be kept`);
  }

  open(text: string): OpenedScene {
    return this.call("open", text);
  }

  bake(lut: string, coarse = false): BakedLut {
    const baked = this.call<Omit<BakedLut, "texels">>("bake", lut, coarse);
    return { ...baked, texels: this.floats() };
  }

  exr(lut: string): Uint8Array {
    this.call("exr", lut);
    return this.bytes();
  }

  /** CIE XYZ of a LUT's texels before they are rounded, for tests. */
  xyz(lut: string): Float64Array {
    this.call("xyz", lut);
    return new Float64Array(this.bytes().buffer);
  }

  manifest(lut: string): string {
    return this.call("manifest", lut);
  }

  snippet(language: "glsl" | "hlsl"): string {
    return this.call("snippet", language);
  }

  cost(lut: string, maxDe00: number): CostPoint {
    return this.call("cost", lut, maxDe00);
  }

  paletteField(pick: Pick, maxWidthNm: number, width: number, height: number): Float32Array {
    this.call("paletteField", pick, maxWidthNm, width, height);
    return this.floats();
  }

  findStructure(material: string, mechanism: string, step: (done: number) => void): { text: string; summary: string } {
    this.module.step = step;
    try {
      return this.call("findStructure", material, mechanism);
    } finally {
      delete this.module.step;
    }
  }

  shippedMaterials(): Listed[] {
    return this.call("shippedMaterials");
  }

  shippedScenes(): { name: string; title: string; text: string }[] {
    return this.scenes;
  }

  private call<Result>(name: string, ...callArguments: unknown[]): Result {
    const json = this.withText(name, (nameAddress) =>
      this.withText(JSON.stringify(callArguments), (argumentsAddress) =>
        this.module.UTF8ToString(this.module._nacre_call(nameAddress, argumentsAddress)),
      ),
    );
    const answer = JSON.parse(json) as { result: Result; error?: string };
    if (answer.error !== undefined) throw new Error(answer.error);
    return answer.result;
  }

  private withText<Result>(text: string, use: (address: number) => Result): Result {
    const size = this.module.lengthBytesUTF8(text) + 1;
    const address = this.module._malloc(size);
    this.module.stringToUTF8(text, address, size);
    const result = use(address);
    this.module._free(address);
    return result;
  }

  // A copy: the module's memory may move when it grows.
  private bytes(): Uint8Array<ArrayBuffer> {
    const first = this.module._nacre_bytes();
    return this.module.HEAPU8.slice(first, first + this.module._nacre_byte_count()) as Uint8Array<ArrayBuffer>;
  }

  private floats(): Float32Array {
    return new Float32Array(this.bytes().buffer);
  }
}
