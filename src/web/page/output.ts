// The output window: an object lit through the LUT, in WebGL 2. Drag turns it, the wheel zooms, Shift or the right
// button moves the light. `data-frame` of the canvas counts the pictures that are done.

import type { BakedLut } from "./api";
import { clamped, direction, Eye, listen } from "./camera";
import { describe, drawn, program, type Uniforms, uploadLut, type Use } from "./graphics";
import { type ObjectName, shownObject } from "./objects";
import { sources } from "./shaders";
import type { Point } from "./surfaces";

export interface OutputSettings {
  environment: boolean;
  roughness: number;
  /** EV, of the light on the object. */
  exposure: number;
  /** Degrees: around from the viewer to the right, and up. */
  light: [number, number];
  /** auto: a board behind what one sees through, if the scene says what passes. */
  background: "auto" | "room" | "board";
  /** Where on the second axis of a LUT over a parameter, from 0 to 1; null: it runs over the surface. */
  row: number | null;
  /** An angle in degrees: the whole window shows the LUT's colour there, as it is. null: the object. */
  flat: number | null;
}

const identity = [1, 0, 0, 0, 1, 0, 0, 0, 1];
// From linear Rec.709 to linear Display P3, from the primaries of both; column by column.
const toDisplayP3 = [0.822462, 0.0331942, 0.0170826, 0.177538, 0.9668058, 0.0723974, 0, 0, 0.9105199];
const scaleOfScreen = (): number => Math.min(devicePixelRatio, 2);

export class OutputView {
  private readonly gl: WebGL2RenderingContext | null;
  /** Programs and meshes by name, made when they are first needed. */
  private readonly programs = new Map<string, Use>();
  private readonly meshes = new Map<ObjectName, () => void>();
  private textures: WebGLTexture[] = [];
  private settings: OutputSettings = {
    environment: true, roughness: 0.2, exposure: 0, light: [-40, 50], background: "auto", row: null, flat: null,
  };
  private name: ObjectName = "sphere";
  private lut: BakedLut | null = null;
  private through: BakedLut | undefined;
  private described: ReturnType<typeof describe> | undefined;
  private turn = 0;
  private pitch = 8;
  private zoom = 1;
  private request = 0;
  private done: WebGLSync | null = null;  // when the last picture is
  private frames = 0;

  constructor(private readonly canvas: HTMLCanvasElement, private readonly snippet: string) {
    this.gl = canvas.getContext("webgl2", { alpha: false });
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
      this.programs.clear();
      this.meshes.clear();
      this.textures = [];
      this.setLut(this.lut, this.through);
    });
    new ResizeObserver(() => this.draw()).observe(canvas);
    if (this.gl && matchMedia("(color-gamut: p3)").matches) this.gl.drawingBufferColorSpace = "display-p3";
    if (this.gl) listen(canvas, this);
  }

  /** What is mirrored, and what passes, if the scene says so. */
  setLut(reflected: BakedLut | null, transmitted?: BakedLut): void {
    [this.lut, this.through] = [reflected, transmitted];
    for (const texture of this.textures) this.gl?.deleteTexture(texture);
    const both = reflected ? [reflected, transmitted ?? reflected] : [];
    this.textures = this.gl ? both.map((lut, unit) => uploadLut(this.gl!, unit, lut)) : [];
    this.described = reflected ? describe(reflected, transmitted !== undefined) : undefined;
    this.draw();
  }

  /** Shows an object as it is first seen. */
  setObject(name: ObjectName): void {
    this.name = name;
    ({ turn: this.turn, pitch: this.pitch } = shownObject(name));
    this.zoom = 1;
    this.draw();
  }

  set(changes: Partial<OutputSettings>): void {
    Object.assign(this.settings, changes);
    this.draw();
  }

  /** Soon, and once for all changes until then; not before the last picture is done, so that nobody waits for it. */
  draw(): void {
    this.request ||= requestAnimationFrame(() => {
      this.request = 0;
      this.drawWhenFree();
    });
  }

  /** At once, unless the last picture is not done: then soon. */
  drawWhenFree(): void {
    const { gl, done } = this;
    if (gl && done && gl.getSyncParameter(done, gl.SYNC_STATUS) === gl.UNSIGNALED) this.draw();
    else this.drawNow();
  }

  drawNow(): void {
    cancelAnimationFrame(this.request);
    this.request = 0;
    const { canvas, gl } = this;
    const width = Math.round(canvas.clientWidth * scaleOfScreen()) || 1;
    const height = Math.round(canvas.clientHeight * scaleOfScreen()) || 1;
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    if (!gl) this.sayThatThereIsNone();
    else if (!gl.isContextLost()) {
      this.drawWith(gl);
      if (this.done) gl.deleteSync(this.done);
      this.done = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
      gl.flush();
    }
    canvas.dataset.frame = String(++this.frames);
  }

  /** Red, green, blue and alpha, from 0 to 255, of the pixel at a place in CSS pixels from the upper left. */
  readPixel(x: number, y: number): number[] {
    this.drawNow();
    const pixel = new Uint8Array(4);
    const [column, row] = [x, y].map((at) => Math.floor(at * scaleOfScreen())) as [number, number];
    const { gl } = this;
    gl?.readPixels(column, this.canvas.height - 1 - row, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return [...pixel];
  }

  /** By degrees. */
  turned(right: number, up: number): void {
    this.turn = (this.turn + right) % 360;
    this.pitch = clamped(this.pitch - up, shownObject(this.name).shade[0] > 0.01 ? -2 : -75, 85); // not below the floor
    this.draw();
  }

  zoomed(factor: number): void {
    this.zoom = clamped(this.zoom * factor, 0.4, 8);
    this.draw();
  }

  /** By degrees. The page hears of it by the event "lightmoved", whose detail is the new light. */
  lightMoved(right: number, up: number): void {
    const [around, height] = this.settings.light;
    const light: [number, number] = [((around + right + 540) % 360) - 180, clamped(height + up, -10, 90)];
    this.set({ light });
    this.canvas.dispatchEvent(new CustomEvent("lightmoved", { detail: light }));
  }

  reset(): void {
    this.setObject(this.name);
  }

  /** Whether the light's marker is there, in CSS pixels from the upper left. */
  isOnLight(x: number, y: number): boolean {
    const [right, up] = this.eye().onPicture(this.lightAt());
    const { clientWidth: width, clientHeight: height } = this.canvas;
    return Math.hypot(x - (0.5 + 0.5 * right) * width, y - (0.5 - 0.5 * up) * height) < 16;
  }

  private sayThatThereIsNone(): void {
    const context = this.canvas.getContext("2d");
    if (!context) return;
    context.font = `${14 * scaleOfScreen()}px system-ui, sans-serif`;
    context.fillStyle = "#888888";
    context.fillText("This browser has no WebGL 2, so the lit object is not shown.", 20, this.canvas.height / 2);
  }

  private drawWith(gl: WebGL2RenderingContext): void {
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clear(gl.DEPTH_BUFFER_BIT | gl.COLOR_BUFFER_BIT);
    const { settings, described, name } = this;
    const eye = this.eye();
    const uniforms = { ...described?.uniforms, ...this.uniforms(eye) };
    if (described && settings.flat !== null) {
      this.program("FLAT", described.defines)({ ...uniforms, cosine: Math.cos((settings.flat * Math.PI) / 180) });
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      return;
    }
    gl.enable(gl.DEPTH_TEST);
    if (described) {
      this.program(name.toUpperCase(), described.defines)(uniforms);
      if (!this.meshes.has(name)) this.meshes.set(name, drawn(gl, shownObject(name).mesh));
      this.meshes.get(name)!();
    }
    this.program("ROOM", "")({ ...uniforms, roomTurn: [1, 0, 0, 1] });
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.program("MARKER", "")(uniforms);
    gl.drawArrays(gl.POINTS, 0, 1);
    gl.disable(gl.BLEND);
  }

  private program(name: string, defines: string): Use {
    const key = `#define ${name}\n${defines}`;
    const known = this.programs.get(key) ?? program(this.gl!, ...sources(name, key, this.snippet));
    this.programs.set(key, known);
    return known;
  }

  private eye(): Eye {
    return new Eye(shownObject(this.name), this.pitch, this.zoom, this.canvas.width / this.canvas.height);
  }

  /** Where the light's marker is, in space. */
  private lightAt(): Point {
    const distance = 1.12 * Math.min(shownObject(this.name).reach[1], 1.1);
    return direction(this.settings.light).map((value) => distance * value) as Point;
  }

  private uniforms(eye: Eye): Uniforms {
    const { settings, name } = this;
    const object = shownObject(name);
    const [c, s] = [Math.cos((this.turn * Math.PI) / 180), Math.sin((this.turn * Math.PI) / 180)];
    const isBall = name === "sphere" || name === "bubble"; // looks the same from all sides: the room turns instead
    const isThrough = name === "bubble" && this.through && settings.background === "auto";
    return {
      view: eye.matrix(),
      camera: [...eye.right.map((v) => v * eye.half[0]), ...eye.up.map((v) => v * eye.half[1]), ...eye.forward],
      turn: isBall ? identity : [c, 0, -s, 0, 1, 0, s, 0, c],
      roomTurn: isBall ? [c, s, -s, c] : [1, 0, 0, 1],
      shadeTurn: [c, s, -s, c],
      eye: eye.from,
      light: direction(settings.light),
      environment: settings.environment ? 1 : 0,
      floorAt: object.floor,
      shadeSize: object.shade,
      fixedRow: settings.row ?? (settings.flat === null ? -1 : 0.5),
      roughness: settings.roughness,
      brightness: 2 ** Math.max(-20, Math.min(20, settings.exposure)),
      gain: (this.described?.gain ?? 1) * (name === "bubble" ? 3 : name === "wing" ? 1.5 : 1),
      board: isThrough || settings.background === "board" ? 1 : 0,
      toGamut: this.gl?.drawingBufferColorSpace === "display-p3" ? toDisplayP3 : identity,
      marker: [...eye.onPicture(this.lightAt()), 20 * scaleOfScreen()],
      strength: this.lightAt()[2] < -0.1 ? 0.25 : 0.6,
    };
  }
}
