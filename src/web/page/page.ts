// What the panels share: the scene, what is selected in it, and the two engines.

import type { AsyncEngine, BakedLut, Engine, LutSummary, Material } from "./api";
import type { SceneDocument } from "./document";

export interface Page {
  readonly doc: SceneDocument;
  readonly here: Engine;
  readonly worker: AsyncEngine;
  /** The LUT that is shown, its material, and the pick of it that is selected. */
  lut: LutSummary | undefined;
  material: Material | undefined;
  pick: number;
  baked: BakedLut | undefined;
  /** The other LUT of a pair: what is seen through. */
  transmitted: BakedLut | undefined;
  /** Whether `baked` is a quick answer. */
  isCoarse: boolean;
  selectPick(pick: number): void;
  selectLut(name: string): void;
  /** Says something in the status line, to screen readers too. */
  say(message: string): void;
  /** The worker does one thing at a time. This runs when it has nothing more urgent to do; nothing if that never came. */
  inSpareTime<Result>(work: () => Promise<Result>): Promise<Result | undefined>;
  /** Another scene: its own object in the output, its own first LUT. To be called before its text is set. */
  anotherScene(name: string): void;
  /** Asks whichever engine baked what is shown. */
  asked<Result>(work: (engine: Engine | AsyncEngine, lut: string) => Result | Promise<Result>): Promise<Result>;
  /** Asks the worker about the scene that is shown. */
  inWorker<Result>(work: (worker: AsyncEngine, lut: string) => Promise<Result>): Promise<Result>;
}

/** "material.morpho", with the name in quotes where TOML wants them. */
export function materialPath(material: Material): string {
  return `material.${/^[\w-]+$/.test(material.name) ? material.name : JSON.stringify(material.name)}`;
}
