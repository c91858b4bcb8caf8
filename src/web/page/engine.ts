// Starts nacre twice: on the page's own thread, for what fits into a frame, and in a worker for the rest. Everything is
// in the page's one script, because pages that are opened from a folder cannot load anything.

import createNacre from "nacre-module";
import wasm from "nacre-wasm";
import scenes from "nacre-scenes";
import workerScript from "nacre-worker";
import type { AsyncEngine, Engine } from "./api";
import { makeEngine, type ModuleEngine } from "./module";
import type { Reply, Request } from "./worker";

interface Waiting {
  resolve: (result: unknown) => void;
  reject: (failure: Error) => void;
  step?: (done: number) => void;
}

class WorkerEngine implements AsyncEngine {
  private worker = this.started();
  private next = 0;
  private readonly waiting = new Map<number, Waiting>();
  // What a new worker has to be told again after cancel().
  private readonly files = new Map<string, Uint8Array>();
  private text = "";

  putFile: AsyncEngine["putFile"] = (path, bytes) => {
    this.files.set(path, bytes);
    return this.ask("putFile", [path, bytes]);
  };
  open: AsyncEngine["open"] = (text) => {
    this.text = text;
    return this.ask("open", [text]);
  };
  bake: AsyncEngine["bake"] = (lut, coarse) => this.ask("bake", [lut, coarse ?? false]);
  exr: AsyncEngine["exr"] = (lut) => this.ask("exr", [lut]);
  manifest: AsyncEngine["manifest"] = (lut) => this.ask("manifest", [lut]);
  cost: AsyncEngine["cost"] = (lut, maxDe00) => this.ask("cost", [lut, maxDe00]);
  findStructure: AsyncEngine["findStructure"] = (material, mechanism, step) =>
    this.ask("findStructure", [material, mechanism], step);

  cancel(): void {
    this.worker.terminate();
    for (const { reject } of this.waiting.values()) reject(new Error("cancelled"));
    this.waiting.clear();
    this.worker = this.started();
    // Another cancel() rejects these; nobody waits for them.
    const ignored = (): void => undefined;
    for (const [path, bytes] of this.files) this.ask("putFile", [path, bytes]).catch(ignored);
    if (this.text !== "") this.ask("open", [this.text]).catch(ignored);
  }

  private started(): Worker {
    const address = URL.createObjectURL(new Blob([workerScript], { type: "text/javascript" }));
    const worker = new Worker(address);
    URL.revokeObjectURL(address);
    worker.onmessage = (event: MessageEvent<Reply>) => this.receive(event.data);
    worker.postMessage({ wasm, scenes } satisfies Request);
    return worker;
  }

  private receive(reply: Reply): void {
    const waiting = this.waiting.get(reply.id);
    if (!waiting) return;
    if ("step" in reply) {
      waiting.step?.(reply.step);
      return;
    }
    this.waiting.delete(reply.id);
    if ("error" in reply) waiting.reject(new Error(reply.error));
    else waiting.resolve(reply.result);
  }

  private ask<Result>(
    name: keyof ModuleEngine,
    callArguments: unknown[],
    step?: (done: number) => void,
  ): Promise<Result> {
    const id = this.next++;
    return new Promise<Result>((resolve, reject) => {
      this.waiting.set(id, { resolve: resolve as (result: unknown) => void, reject, ...(step ? { step } : {}) });
      this.worker.postMessage({ id, name, arguments: callArguments } satisfies Request);
    });
  }
}

export async function startEngine(): Promise<{ here: Engine; worker: AsyncEngine }> {
  return { here: await makeEngine(createNacre, wasm, scenes), worker: new WorkerEngine() };
}
