// Bakes in the worker: a coarse answer first, the exact one after it. What is out of date is dropped.

import type { AsyncEngine, BakedLut } from "./api";

export interface BakeRequest {
  text: string;
  /** The LUT that is shown, and the other of a pair if it is one. */
  luts: string[];
}

// An exact bake that is out of date may go on for so long before the worker is ended.
const patienceMs = 100;

export class WorkerBakes {
  private wanted: BakeRequest | undefined;
  private exact: BakeRequest | undefined;
  private isRunning = false;
  private idle: (() => void)[] = [];

  constructor(
    private readonly worker: AsyncEngine,
    private readonly show: (request: BakeRequest, baked: BakedLut[], isCoarse: boolean) => void,
    private readonly fail: (message: string) => void,
    private readonly mayCancel: () => boolean,
  ) {}

  request(wanted: BakeRequest): void {
    this.wanted = wanted;
    const old = this.exact;
    if (old) setTimeout(() => this.exact === old && this.mayCancel() && this.worker.cancel(), patienceMs);
    if (!this.isRunning) void this.run();
  }

  /** Nothing is wanted any more: the page itself answers. */
  forget(): void {
    this.wanted = undefined;
  }

  get isBusy(): boolean {
    return this.isRunning;
  }

  async whenIdle(): Promise<void> {
    if (this.isRunning) await new Promise<void>((resolve) => this.idle.push(resolve));
  }

  private async run(): Promise<void> {
    this.isRunning = true;
    while (this.wanted) {
      const request = this.wanted;
      this.wanted = undefined;
      try {
        this.show(request, await this.bake(request, true), true);
        if (this.wanted) continue;
        this.exact = request;
        const baked = await this.bake(request, false);
        if (!this.wanted) this.show(request, baked, false);
      } catch (failure) {
        if (!this.wanted) this.fail((failure as Error).message);
      }
      this.exact = undefined;
    }
    this.isRunning = false;
    for (const resume of this.idle.splice(0)) resume();
  }

  private async bake({ text, luts }: BakeRequest, isCoarse: boolean): Promise<BakedLut[]> {
    const [, ...baked] = await Promise.all([
      this.worker.open(text),
      ...luts.map((lut) => this.worker.bake(lut, isCoarse)),
    ]);
    return baked as BakedLut[];
  }
}
