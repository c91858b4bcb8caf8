// What the page knows of nacre: the types of src/web/session.h, as JSON. engine.ts implements Engine.

/** Where a value stands in the scene's text. Lines and columns count from 1, columns in characters; the end is the
 *  place behind the last character. */
export interface Place {
  line: number;
  column: number;
  endLine: number;
  endColumn: number;
}

/** Line and column are 0 if a message has no place. */
export interface Mistake {
  message: string;
  line: number;
  column: number;
}

/** One value of the scene's text: a number, a text, a truth value, or an array or a table as a whole. */
export interface SceneValue {
  /** Missing for arrays and tables. */
  value?: number | string | boolean;
  place: Place;
}

/** One pick of a palette, with what nacre made of its colour if it was given as one. */
export interface Pick {
  angleDeg: number;
  peakNm: number;
  widthNm: number;
  height: number;
  floor: number;
  flatness: number;
  /** How it was given: "#22aa44"; missing if it was given as a band. */
  colour?: string;
  /** Of a pick that is a colour: how far the material's colour is from it, and by how much it is dimmed or moved, in words. */
  de00?: number;
  note?: string;
  /** Linear Rec.709 of the material at the pick's angle. */
  rgb: [number, number, number];
}

export interface Material {
  name: string;
  /** "palette", "film", "stack", "grating", "crystal", "scatter", "measured" */
  mechanism: string;
  /** Of palettes. */
  picks?: Pick[];
  shape?: number;
  /** Of palettes, every whole degree from 0 to 90: the band's peak, width and height between the picks. */
  curve?: { peakNm: number; widthNm: number; height: number; floor: number; flatness: number }[];
}

export interface Axis {
  /** "sqrt_cos_theta", "cos_theta", "theta_deg", "grating_u", "cos_scatter", or the name of a parameter */
  name: string;
  isAngle: boolean;
  /** What the first and the last texel stand for: of sqrt_cos_theta 0 and 1, that is 90 and 0 degrees. */
  from: number;
  to: number;
}

export interface LutSummary {
  name: string;
  material: string;
  /** "reflectance" or "transmittance" */
  quantity: string;
  /** What the scene calls it: the two of a pair share it. */
  entry: string;
  x: Axis;
  y?: Axis;
  maxDe00: number;
}

/** What open() says of a text. If it has mistakes, materials and luts are empty. */
export interface OpenedScene {
  mistakes: Mistake[];
  warnings: string[];
  /** Every value by its path: "material.morpho.picks[0].peak_nm", "accuracy.max_de00", "lut.morpho". Keys with other
   *  characters than letters, digits, _ and - are in quotes, as TOML writes them. Given for every text that is TOML. */
  values: Record<string, SceneValue>;
  materials: Material[];
  luts: LutSummary[];
}

export interface EffectChoice {
  /** "dispersion", "polarisation", "tilt", "roughness" ... as `without` in [accuracy] names them */
  name: string;
  isSimulated: boolean;
  /** Whether the scene said so itself. */
  isGiven: boolean;
  /** dE00 that it changes the colours by, and the share of the bound below which it may be left out. */
  contribution: number;
  share: number;
}

export interface BakedLut extends LutSummary {
  width: number;
  height: number;
  format: "half" | "float";
  /** R, G, B of every texel, linear, in the LUT's colour space; the first row is the smallest y. As stored in the file. */
  texels: Float32Array;
  space: string;
  /** From the LUT's colour space to linear Rec.709, row by row. */
  toRec709: number[];
  /** What the texture errs by at most; missing if it cannot be known. */
  reached?: number;
  /** Size of the EXR file. */
  bytes: number;
  /** Of one thread. */
  seconds: { deciding: number; computing: number; measuring: number };
  effects: EffectChoice[];
  clampedBelowDeg?: number;
  clampedAboveDeg?: number;
  warnings: string[];
}

/** One step of the cost curve: what a bound costs. */
export interface CostPoint {
  maxDe00: number;
  width: number;
  height: number;
  format: "half" | "float";
  bytes: number;
  reached?: number;
  seconds: { deciding: number; computing: number; measuring: number };
  /** Why there is no texture for this bound. */
  failure?: string;
}

/** One entry of a list: a shipped material, a shipped scene. */
export interface Listed {
  name: string;
  about: string;
}

/** nacre itself. On the page's own thread every call returns at once with its result; heavy scenes go to a worker, which
 *  has the same calls (engine.ts). Throws Error with nacre's message. */
export interface Engine {
  version(): string;
  /** A file that scenes may name: a table of spectra, a material. The path is relative to the scene. */
  putFile(path: string, bytes: Uint8Array): void;
  /** Reads and plans a scene. Later calls are about the last scene that had no mistakes. */
  open(text: string): OpenedScene;
  /** Decides, computes and measures one LUT of the opened scene.
   *  @param coarse true: at 8 times the bound, without a check: the quick answer of a heavy scene. */
  bake(lut: string, coarse?: boolean): BakedLut;
  /** The file of a LUT as `nacre bake` writes it, and its manifest. */
  exr(lut: string): Uint8Array;
  manifest(lut: string): string;
  /** "glsl" or "hlsl" */
  snippet(language: "glsl" | "hlsl"): string;
  cost(lut: string, maxDe00: number): CostPoint;
  /** Linear Rec.709 of bands, width x height of them: x is width_nm from 0 to maxWidthNm, y is the height from 0 (first
   *  row) to 1, all else as in the pick. */
  paletteField(pick: Pick, maxWidthNm: number, width: number, height: number): Float32Array;
  /** Searches structures of a mechanism ("film", "stack", "grating" ...) that show the picks of a palette, and gives the
   *  scene's text with the best of them. `step` is called now and then. */
  findStructure(material: string, mechanism: string, step: (done: number) => void): { text: string; summary: string };
  shippedMaterials(): Listed[];
  /** `title` is the scene's first line of comment. */
  shippedScenes(): { name: string; title: string; text: string }[];
}

/** Engine in a worker: the same calls, answered later. */
export interface AsyncEngine {
  putFile(path: string, bytes: Uint8Array): Promise<void>;
  open(text: string): Promise<OpenedScene>;
  bake(lut: string, coarse?: boolean): Promise<BakedLut>;
  exr(lut: string): Promise<Uint8Array>;
  manifest(lut: string): Promise<string>;
  cost(lut: string, maxDe00: number): Promise<CostPoint>;
  findStructure(
    material: string,
    mechanism: string,
    step: (done: number) => void,
  ): Promise<{ text: string; summary: string }>;
  /** Ends whatever it does; what it was asked is rejected with "cancelled". It goes on with the scene that was open. */
  cancel(): void;
}
