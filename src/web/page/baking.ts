// Bakes in the worker: a coarse answer first, the exact one after it. What is out of date is dropped.

import type { AsyncEngine, BakedLut } from "./api";

/** The LUT that is shown, and the other of a pair if it is one. */
export type BakeRequest = { text: string; luts: string[]; startMs: number };

// An exact bake that is out of date may go on for so long before the worker is ended.
const patienceMs = 100;

export class WorkerBakes {
  isBusy = false;
  private wanted: BakeRequest | undefined;
  private exact: BakeRequest | undefined;

  /** @param mayCancel  false while the worker does something else that is wanted */
  constructor(
    private readonly worker: AsyncEngine,
    private readonly show: (request: BakeRequest, baked: BakedLut[], isCoarse: boolean) => void,
    private readonly fail: (message: string) => void,
    private readonly mayCancel: () => boolean,
  ) {}

  /** Nothing: what was wanted before is wanted no more. */
  request(wanted?: BakeRequest): void {
    this.wanted = wanted;
    const old = this.exact;
    if (old) setTimeout(() => this.exact === old && this.mayCancel() && this.worker.cancel(), patienceMs);
    if (!this.isBusy) void this.run();
  }

  private async run(): Promise<void> {
    this.isBusy = true;
    for (let request = this.wanted; request; request = this.wanted) {
      try {
        const coarse = await this.bake(request, true);
        if (this.wanted) this.show(request, coarse, true);
        if (this.wanted !== request) continue;
        this.exact = request;
        const baked = await this.bake(request, false);
        if (this.wanted === request) this.show(request, baked, false);
      } catch (failure) {
        if (this.wanted === request) this.fail((failure as Error).message);
      }
      this.exact = undefined;
      if (this.wanted === request) this.wanted = undefined;
    }
    this.isBusy = false;
  }

  private async bake({ text, luts }: BakeRequest, isCoarse: boolean): Promise<BakedLut[]> {
    const opening = this.worker.open(text);
    const baking = luts.map((lut) => this.worker.bake(lut, isCoarse));
    return (await Promise.all([Promise.all(baking), opening]))[0];
  }
}
