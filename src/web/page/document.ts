// The scene as text is the only model: every control changes the text, and nacre reads it. Undo, redo, and the address.

import type { Engine, Material, OpenedScene } from "./api";
import { withItem, without, withValues, type TomlValue } from "./toml_text";

// Keys that are pressed further apart are steps of their own in undo.
const gestureMs = 1000;

export class SceneDocument {
  text = "";
  /** Of the text as it is, perhaps with mistakes; and of the last text without. */
  opened: OpenedScene = { mistakes: [], warnings: [], values: {}, materials: [], luts: [] };
  scene = this.opened;
  goodText = "";
  /** How long nacre took to read the text. */
  openMs = 0;
  /** Called after every change. */
  onChange: () => void = () => {};
  private steps: string[] = [];
  private at = -1;
  private last = { gesture: "", ms: 0 };

  constructor(private readonly engine: Engine) {}

  /** Another text. Edits with the same gesture are one step of undo. */
  replace(text: string, gesture = ""): void {
    if (text === this.text) return this.read();
    const ms = performance.now();
    const isHeld = !/^(keys|typing)/.test(gesture) || ms - this.last.ms < gestureMs;
    const isSameStep = gesture !== "" && gesture === this.last.gesture && isHeld;
    this.steps.splice(isSameStep ? this.at : this.at + 1, Infinity, text);
    this.at = this.steps.length - 1;
    this.last = { gesture, ms };
    this.read(text);
  }

  /** Sets values of a table by their keys, or of the scene by their paths. What is missing is inserted. */
  set(changes: Record<string, TomlValue>, gesture = "", table = ""): void {
    const areThere = Object.keys(changes).every((key) => this.has(table === "" ? key : `${table}.${key}`));
    if (!areThere && this.isWrong()) return;
    this.replace(withValues(this.text, this.opened.values, changes, table), gesture);
  }

  addItem(array: string, item: string): void {
    if (!this.isWrong()) this.replace(withItem(this.text, this.opened.values, array, item));
  }

  remove(path: string): void {
    if (!this.isWrong()) this.replace(without(this.text, this.opened.values, path));
  }

  // The panels show the last scene without mistakes: of the wrong text they may only correct values.
  private isWrong(): boolean {
    if (this.opened.mistakes.length > 0) this.onChange();
    return this.opened.mistakes.length > 0;
  }

  /** Sets some keys of a table and removes others, as one step. */
  exchange(table: string, changes: Record<string, TomlValue>, removed: string[], gesture: string): void {
    if (this.isWrong()) return;
    let text = withValues(this.text, this.opened.values, changes, table);
    for (const key of removed) text = without(text, this.engine.open(text).values, `${table}.${key}`);
    this.replace(text, gesture);
  }

  readonly has = (path: string): boolean => this.opened.values[path] !== undefined;
  /** A number, text or truth value; nothing for tables and arrays. */
  readonly value = (path: string) => this.opened.values[path]?.value;

  /** What the light of the scene is, to compare. */
  get light(): string {
    const values = Object.entries(this.scene.values).filter(([path]) => path.startsWith("light"));
    return values.map(([path, { value }]) => `${path}=${value}`).join();
  }

  /** Whether there is a step back (-1) or forth (1). */
  readonly canStep = (direction: number): boolean => this.steps[this.at + direction] !== undefined;

  step(direction: number): void {
    if (!this.canStep(direction)) return;
    this.at += direction;
    this.last.gesture = "";
    this.read(this.steps[this.at]!);
  }

  /** Reads the text, again if a file that it names has changed. */
  read(text = this.text): void {
    const start = performance.now();
    this.text = text;
    this.opened = this.engine.open(text);
    if (this.opened.mistakes.length === 0) [this.scene, this.goodText] = [this.opened, text];
    this.openMs = performance.now() - start;
    this.onChange();
  }
}

/** "material.morpho", with the name in quotes where TOML wants them. */
export const materialPath = ({ name }: Material): string =>
  `material.${/^[\w-]+$/.test(name) ? name : JSON.stringify(name)}`;

async function piped(bytes: Uint8Array, through: CompressionStream | DecompressionStream): Promise<Uint8Array> {
  return new Uint8Array(await new Response(new Blob([bytes as BlobPart]).stream().pipeThrough(through)).arrayBuffer());
}

/** The text as a part of an address: deflated, in base64url. */
export async function inAddress(text: string): Promise<string> {
  const bytes = await piped(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  const base64 = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  return base64.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** "" if it is no text of inAddress(). */
export async function fromAddress(hash: string): Promise<string> {
  try {
    const binary = atob(hash.replace("#", "").replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
    return new TextDecoder().decode(await piped(bytes, new DecompressionStream("deflate-raw")));
  } catch {
    return "";
  }
}
