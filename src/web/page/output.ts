// The output window: an object lit through the LUT, in WebGL 2. Drag turns it, the wheel zooms, Shift or the right button
// moves the light. `data-frame` of the canvas counts the pictures that are done.

import type { BakedLut } from "./api";
import { clamped, direction, eyeOf, listen, onPicture, viewMatrix } from "./camera";
import type { Eye } from "./camera";
import { DrawnMesh, Program, uniformsOf, uploadLut } from "./graphics";
import { shownObject } from "./objects";
import type { ObjectName } from "./objects";
import * as shaders from "./shaders";
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
  /** An angle in degrees: the whole window shows the LUT's colour there, without light or exposure. null: the object. */
  flat: number | null;
}

interface Graphics {
  room: Program;
  /** Of an object or "flat", and the LUT's axes. */
  ofLut: Map<string, Program>;
  marker: Program;
  meshes: Map<ObjectName, DrawnMesh>;
  textures: WebGLTexture[];
}

const identity = [1, 0, 0, 0, 1, 0, 0, 0, 1];
// From linear Rec.709 to linear Display P3, from the primaries of both; column by column.
const toDisplayP3 = [0.8224620, 0.0331942, 0.0170826, 0.1775380, 0.9668058, 0.0723974, 0, 0, 0.9105199];

export class OutputView {
  private readonly gl: WebGL2RenderingContext | null;
  private graphics: Graphics | undefined;
  private settings: OutputSettings = {
    environment: true, roughness: 0.2, exposure: 0, light: [-40, 50], background: "auto", row: null, flat: null,
  };
  private name: ObjectName = "sphere";
  private lut: BakedLut | null = null;
  private through: BakedLut | undefined;
  private ofLut: Record<string, number | number[]> = {};
  private gain = 1;
  private defines = "";
  private turn = 0;
  private pitch = 8;
  private zoom = 1;
  private request = 0;
  private frames = 0;

  constructor(private readonly canvas: HTMLCanvasElement, private readonly snippet: string) {
    this.gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
    if (!this.gl) return;
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.graphics = undefined;
    });
    canvas.addEventListener("webglcontextrestored", () => {
      this.prepare();
      this.draw();
    });
    this.prepare();
    listen(canvas, {
      turned: (right, up) => this.turned(right, up),
      zoomed: (factor) => this.zoomed(factor),
      lightMoved: (right, up) => this.lightMoved(right, up),
      reset: () => this.setObject(this.name),
      isOnLight: (x, y) => this.isOnLight(x, y),
    });
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  /** What is mirrored, and what passes, if the scene says so. */
  setLut(reflected: BakedLut | null, transmitted?: BakedLut): void {
    this.lut = reflected;
    this.through = transmitted;
    this.upload();
    this.draw();
  }

  /** Shows an object as it is first seen. */
  setObject(name: ObjectName): void {
    const object = shownObject(name);
    this.name = name;
    this.turn = object.turn;
    this.pitch = object.pitch;
    this.zoom = 1;
    this.draw();
  }

  set(changes: Partial<OutputSettings>): void {
    Object.assign(this.settings, changes);
    this.draw();
  }

  /** Soon, and once for all changes until then. */
  draw(): void {
    this.request ||= requestAnimationFrame(() => this.drawNow());
  }

  drawNow(): void {
    cancelAnimationFrame(this.request);
    this.request = 0;
    this.fitCanvas();
    if (!this.gl) this.sayThatThereIsNone();
    else if (this.graphics && !this.gl.isContextLost()) this.drawWith(this.gl, this.graphics);
    this.canvas.dataset.frame = String(++this.frames);
  }

  /** Red, green, blue and alpha, from 0 to 255, of the pixel at a place in CSS pixels from the upper left. */
  readPixel(x: number, y: number): number[] {
    this.drawNow();
    const pixel = new Uint8Array(4);
    const scale = this.canvas.width / Math.max(this.canvas.clientWidth, 1);
    const { gl } = this;
    gl?.readPixels(Math.floor(x * scale), this.canvas.height - 1 - Math.floor(y * scale), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return [...pixel];
  }

  private prepare(): void {
    const gl = this.gl!;
    if (gl.isContextLost()) return;
    const isWide = "drawingBufferColorSpace" in gl && matchMedia("(color-gamut: p3)").matches;
    if (isWide) gl.drawingBufferColorSpace = "display-p3";
    this.graphics = {
      room: new Program(gl, shaders.vertexOfScreen, shaders.fragmentOfRoom),
      ofLut: new Map(),
      marker: new Program(gl, shaders.vertexOfMarker, shaders.fragmentOfMarker),
      meshes: new Map(),
      textures: [],
    };
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.upload();
  }

  private upload(): void {
    const { gl, graphics, lut, through } = this;
    if (!gl || !graphics || !lut) return;
    for (const texture of graphics.textures) gl.deleteTexture(texture);
    graphics.textures = [uploadLut(gl, 0, lut), uploadLut(gl, 1, through ?? lut)];
    ({ uniforms: this.ofLut, gain: this.gain, defines: this.defines } = uniformsOf(lut, through !== undefined));
  }

  private fitCanvas(): void {
    const scale = Math.min(devicePixelRatio, 2);
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight].map((side) => Math.max(1, Math.round(side * scale)));
    if (this.canvas.width !== width) this.canvas.width = width!;
    if (this.canvas.height !== height) this.canvas.height = height!;
  }

  private sayThatThereIsNone(): void {
    const context = this.canvas.getContext("2d");
    if (!context) return;
    context.fillStyle = "#888888";
    context.font = `${16 * Math.min(devicePixelRatio, 2)}px system-ui, sans-serif`;
    context.textAlign = "center";
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.fillText("This browser has no WebGL 2, so the lit object is not shown.", this.canvas.width / 2, this.canvas.height / 2);
  }

  private drawWith(gl: WebGL2RenderingContext, graphics: Graphics): void {
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clear(gl.DEPTH_BUFFER_BIT | gl.COLOR_BUFFER_BIT);
    const toGamut = gl.drawingBufferColorSpace === "display-p3" ? toDisplayP3 : identity;
    if (this.settings.flat !== null && this.lut) {
      const cosine = Math.cos((this.settings.flat * Math.PI) / 180);
      this.programOf(gl, graphics, "flat").use({ ...this.ofLut, fixedRow: this.settings.row ?? 0.5, cosine, toGamut });
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      return;
    }
    const eye = this.eye();
    const uniforms = { ...this.uniforms(eye), toGamut };
    if (this.lut) {
      this.programOf(gl, graphics, this.name).use({ ...this.ofLut, ...uniforms });
      const mesh = graphics.meshes.get(this.name) ?? new DrawnMesh(gl, shownObject(this.name).mesh);
      graphics.meshes.set(this.name, mesh);
      mesh.draw();
    }
    const camera = [...eye.right.map((v) => v * eye.half[0]), ...eye.up.map((v) => v * eye.half[1]), ...eye.forward];
    graphics.room.use({ ...uniforms, camera, roomTurn: [1, 0, 0, 1] });
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    this.drawMarker(gl, graphics, eye);
  }

  private programOf(gl: WebGL2RenderingContext, graphics: Graphics, name: ObjectName | "flat"): Program {
    const key = `#define ${name.toUpperCase()}\n${this.defines}`;
    const known = graphics.ofLut.get(key);
    if (known) return known;
    const made =
      name === "flat"
        ? new Program(gl, shaders.vertexOfScreen, shaders.fragmentOfFlat(this.snippet, key))
        : new Program(gl, shaders.vertexOfObject, shaders.fragmentOfObject(this.snippet, key));
    graphics.ofLut.set(key, made);
    return made;
  }

  private drawMarker(gl: WebGL2RenderingContext, graphics: Graphics, eye: Eye): void {
    const isBehind = this.lightAt()[2] < -0.1;
    graphics.marker.use({
      marker: [...onPicture(eye, this.lightAt()), 20 * Math.min(devicePixelRatio, 2)],
      strength: isBehind ? 0.25 : 0.6,
    });
    gl.enable(gl.BLEND);
    gl.disable(gl.DEPTH_TEST);
    gl.drawArrays(gl.POINTS, 0, 1);
    gl.disable(gl.BLEND);
    gl.enable(gl.DEPTH_TEST);
  }

  private eye(): Eye {
    return eyeOf(shownObject(this.name), this.pitch, this.zoom, this.canvas.width / this.canvas.height);
  }

  private uniforms(eye: Eye): Record<string, number | number[]> {
    const object = shownObject(this.name);
    const { settings } = this;
    const [c, s] = [Math.cos((this.turn * Math.PI) / 180), Math.sin((this.turn * Math.PI) / 180)];
    const isBall = this.name === "sphere" || this.name === "bubble";
    const isBoard = settings.background === "auto" ? this.name === "bubble" && this.through : settings.background === "board";
    return {
      view: viewMatrix(eye),
      // A ball looks the same from all sides, so the room turns around it instead.
      turn: isBall ? identity : [c, 0, -s, 0, 1, 0, s, 0, c],
      roomTurn: isBall ? [c, s, -s, c] : [1, 0, 0, 1],
      shadeTurn: [c, s, -s, c],
      eye: eye.from,
      light: direction(settings.light),
      environment: settings.environment ? 1 : 0,
      floorAt: object.floor,
      shadeSize: object.shade,
      fixedRow: settings.row ?? -1,
      roughness: settings.roughness,
      exposure: settings.exposure,
      gain: this.gain * (this.name === "bubble" ? 2 : this.name === "wing" ? 1.5 : 1),
      board: isBoard ? 1 : 0,
      boardFacing: eye.forward,
      boardAcross: eye.right,
    };
  }

  private turned(right: number, up: number): void {
    const isAboveFloor = shownObject(this.name).shade[0] > 0.01;
    this.turn = (this.turn + right) % 360;
    this.pitch = clamped(this.pitch - up, isAboveFloor ? -2 : -75, 85);
    this.draw();
  }

  private zoomed(factor: number): void {
    this.zoom = clamped(this.zoom * factor, 0.4, 8);
    this.draw();
  }

  /** The page hears of it by the event "lightmoved", whose detail is the new light. */
  private lightMoved(right: number, up: number): void {
    const [around, height] = this.settings.light;
    const light: [number, number] = [((around + right + 540) % 360) - 180, clamped(height + up, -10, 90)];
    this.set({ light });
    this.canvas.dispatchEvent(new CustomEvent("lightmoved", { detail: light }));
  }

  /** Where the marker is, in space. */
  private lightAt(): Point {
    const distance = 1.12 * Math.min(shownObject(this.name).reach, 1.1);
    return direction(this.settings.light).map((value) => distance * value) as Point;
  }

  private isOnLight(x: number, y: number): boolean {
    const [right, up] = onPicture(this.eye(), this.lightAt());
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    return Math.hypot(x - (0.5 + 0.5 * right) * width, y - (0.5 - 0.5 * up) * height) < 16;
  }
}
