// The scene as text is the only model: every control changes the text, and nacre reads it. Undo, redo, and the address.

import type { Engine, OpenedScene, SceneValue } from "./api";
import { withItem, without, withValues, type TomlValue } from "./toml_text";

// Edits of one gesture that are further apart are steps of their own in undo.
const gestureMs = 1000;
const mostSteps = 500;

export class SceneDocument {
  text = "";
  /** Of the text as it is, perhaps with mistakes. */
  opened: OpenedScene = { mistakes: [], warnings: [], values: {}, materials: [], luts: [] };
  /** Of the last text without mistakes. */
  scene: OpenedScene = this.opened;
  /** How long nacre took to read the text. */
  openMs = 0;
  /** Called after every change. */
  onChange: () => void = () => {};

  private steps: string[] = [];
  private at = -1;
  private gesture = "";
  private editedMs = 0;

  constructor(private readonly engine: Engine) {}

  /** Another text. Edits with the same gesture are one step of undo. */
  replace(text: string, gesture = ""): void {
    if (text === this.text) return;
    const now = performance.now();
    const isSameStep = gesture !== "" && gesture === this.gesture && now - this.editedMs < gestureMs;
    this.steps.length = this.at + 1;
    if (isSameStep) this.steps.pop();
    this.steps.push(text);
    if (this.steps.length > mostSteps) this.steps.shift();
    this.at = this.steps.length - 1;
    this.gesture = gesture;
    this.editedMs = now;
    this.read(text);
  }

  /** Sets values by their paths. Keys and tables that are missing are inserted. */
  set(changes: Record<string, TomlValue>, gesture = ""): void {
    this.replace(withValues(this.text, this.opened.values, changes), gesture);
  }

  addItem(array: string, literal: string): void {
    this.replace(withItem(this.text, this.opened.values, array, literal));
  }

  remove(path: string): void {
    this.replace(without(this.text, this.opened.values, path));
  }

  /** Sets some keys of a table and removes others, as one step. */
  exchange(table: string, set: Record<string, TomlValue>, removed: string[], gesture: string): void {
    const prefixed = Object.entries(set).map(([key, value]) => [`${table}.${key}`, value]);
    let text = withValues(this.text, this.opened.values, Object.fromEntries(prefixed));
    for (const key of removed) {
      const { values } = this.engine.open(text);
      text = without(text, values, `${table}.${key}`);
    }
    this.replace(text, gesture);
  }

  value(path: string): SceneValue | undefined {
    return this.opened.values[path];
  }

  number(path: string): number | undefined {
    const value = this.value(path)?.value;
    return typeof value === "number" ? value : undefined;
  }

  get canUndo(): boolean {
    return this.at > 0;
  }

  get canRedo(): boolean {
    return this.at < this.steps.length - 1;
  }

  /** One step back (-1) or forth (1). */
  step(direction: number): void {
    const text = this.steps[this.at + direction];
    if (text === undefined) return;
    this.at += direction;
    this.gesture = "";
    this.read(text);
  }

  /** Reads the text again, because a file that it names is there now. */
  reread(): void {
    this.read(this.text);
  }

  private read(text: string): void {
    const start = performance.now();
    this.text = text;
    this.opened = this.engine.open(text);
    if (this.opened.mistakes.length === 0) this.scene = this.opened;
    this.openMs = performance.now() - start;
    this.onChange();
  }
}

async function piped(bytes: Uint8Array, through: CompressionStream | DecompressionStream): Promise<Uint8Array> {
  const stream = new Blob([bytes as BlobPart]).stream().pipeThrough(through);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The text as a part of an address: deflated, in base64url. */
export async function inAddress(text: string): Promise<string> {
  const bytes = await piped(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** Nothing if it is no text of inAddress(). */
export async function fromAddress(hash: string): Promise<string | undefined> {
  const packed = hash.replace(/^#/, "");
  if (packed === "") return undefined;
  try {
    const binary = atob(packed.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
    return new TextDecoder().decode(await piped(bytes, new DecompressionStream("deflate-raw")));
  } catch {
    return undefined;
  }
}
