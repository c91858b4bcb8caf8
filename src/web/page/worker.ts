// The worker: the same engine, asked by messages, so that heavy scenes and searches do not hold the page up.

import createNacre from "nacre-module";
import { makeEngine, type ModuleEngine, type ShippedScene } from "./module";

/** First the bytes of the module, then calls of Engine by name. */
export type Request =
  | { wasm: Uint8Array; scenes: ShippedScene[] }
  | { id: number; name: keyof ModuleEngine; arguments: unknown[] };
export type Reply = { id: number; result: unknown } | { id: number; error: string } | { id: number; step: number };

// TypeScript takes this file for a page's, where postMessage wants a target.
const reply = (message: Reply): void => (postMessage as (message: Reply) => void)(message);

let engine: Promise<ModuleEngine> | undefined;

onmessage = async (event: MessageEvent<Request>): Promise<void> => {
  const request = event.data;
  if ("wasm" in request) {
    engine = makeEngine(createNacre, request.wasm, request.scenes);
    return;
  }
  const { id, name } = request;
  try {
    if (!engine) throw new Error("the worker has no module yet");
    const callArguments = [...request.arguments];
    if (name === "findStructure") callArguments.push((done: number) => reply({ id, step: done }));
    const method = (await engine)[name] as (...callArguments: unknown[]) => unknown;
    reply({ id, result: method.apply(await engine, callArguments) });
  } catch (failure) {
    reply({ id, error: failure instanceof Error ? failure.message : String(failure) });
  }
};
