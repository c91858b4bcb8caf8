// What the output window needs of WebGL 2: programs, meshes, and the LUT as a texture.

import type { Axis, BakedLut } from "./api";
import type { Mesh } from "./surfaces";

export class Program {
  private readonly program: WebGLProgram;
  private readonly places: { name: string; type: number; place: WebGLUniformLocation }[] = [];

  constructor(private readonly gl: WebGL2RenderingContext, vertex: string, fragment: string) {
    this.program = gl.createProgram()!;
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
      const shader = gl.createShader(kind)!;
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
      const failed = !gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost();
      if (failed) throw new Error(`The shader does not compile: ${gl.getShaderInfoLog(shader)}`);
    }
    gl.linkProgram(this.program);
  }

  /** Uniforms by name: a number, or the numbers of a vector or a matrix, column by column. */
  use(uniforms: Record<string, number | number[]>): void {
    const { gl } = this;
    gl.useProgram(this.program);
    const count = gl.getProgramParameter(this.program, gl.ACTIVE_UNIFORMS) as number;
    for (let i = this.places.length; i < count; ++i) {
      const { name, type } = gl.getActiveUniform(this.program, i)!;
      this.places.push({ name, type, place: gl.getUniformLocation(this.program, name)! });
    }
    for (const { name, type, place } of this.places) {
      const value = [uniforms[name] ?? 0].flat();
      if (type === gl.SAMPLER_2D) gl.uniform1i(place, value[0]!);
      else if (type === gl.FLOAT) gl.uniform1f(place, value[0]!);
      else if (type === gl.FLOAT_VEC2) gl.uniform2fv(place, value);
      else if (type === gl.FLOAT_VEC3) gl.uniform3fv(place, value);
      else if (type === gl.FLOAT_VEC4) gl.uniform4fv(place, value);
      else if (type === gl.FLOAT_MAT2) gl.uniformMatrix2fv(place, false, value);
      else if (type === gl.FLOAT_MAT3) gl.uniformMatrix3fv(place, false, value);
      else gl.uniformMatrix4fv(place, false, value);
    }
  }
}

export class DrawnMesh {
  private readonly array: WebGLVertexArrayObject;
  private readonly count: number;

  constructor(private readonly gl: WebGL2RenderingContext, mesh: Mesh) {
    this.array = gl.createVertexArray()!;
    this.count = mesh.indices.length;
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(mesh.vertices), gl.STATIC_DRAW);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(mesh.indices), gl.STATIC_DRAW);
    let offset = 0;
    for (const [index, size] of [3, 3, 1, 4].entries()) {
      gl.enableVertexAttribArray(index);
      gl.vertexAttribPointer(index, size, gl.FLOAT, false, 44, offset);
      offset += 4 * size;
    }
    gl.bindVertexArray(null);
  }

  draw(): void {
    this.gl.bindVertexArray(this.array);
    this.gl.drawElements(this.gl.TRIANGLES, this.count, this.gl.UNSIGNED_INT, 0);
    this.gl.bindVertexArray(null);
  }
}

/** Linear, clamped, without mip-maps: as luts/README.md asks. Half floats where floats cannot be filtered. */
export function uploadLut(gl: WebGL2RenderingContext, unit: number, lut: BakedLut): WebGLTexture {
  const format = gl.getExtension("OES_texture_float_linear") ? gl.RGBA32F : gl.RGBA16F;
  const texels = new Float32Array(4 * lut.width * lut.height);
  for (let i = 0; i < lut.width * lut.height; ++i) texels.set([...lut.texels.subarray(3 * i, 3 * i + 3), 1], 4 * i);
  const texture = gl.createTexture()!;
  gl.activeTexture(gl.TEXTURE0 + unit);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, format, lut.width, lut.height, 0, gl.RGBA, gl.FLOAT, texels);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  return texture;
}

/** How shaders.ts finds the place on an axis. */
function axisKind(axis: Axis | undefined): number {
  const kinds = ["sqrt_cos_theta", "cos_theta", "theta_deg", "grating_u", "cos_scatter", "azimuth_deg", "roughness"];
  const kind = axis ? kinds.indexOf(axis.name) : -1;
  return kind < 0 ? kinds.length : kind;
}

const transposed = (m: number[]): number[] => [0, 3, 6, 1, 4, 7, 2, 5, 8].map((i) => m[i]!);

/** The largest component in linear Rec.709. */
function brightest(lut: BakedLut): number {
  let most = 0;
  const m = lut.toRec709;
  for (let i = 0; i < lut.texels.length; i += 3) {
    const [r, g, b] = [lut.texels[i]!, lut.texels[i + 1]!, lut.texels[i + 2]!];
    for (let row = 0; row < 9; row += 3) most = Math.max(most, m[row]! * r + m[row + 1]! * g + m[row + 2]! * b);
  }
  return most;
}

/** What the shaders have to know of a LUT, and by how much its light is brightened so that dark films are seen at all. */
export function uniformsOf(
  lut: BakedLut,
  hasThrough: boolean,
): { uniforms: Record<string, number | number[]>; gain: number; defines: string } {
  const kinds = [axisKind(lut.x), axisKind(lut.y)];
  const quantity = kinds.includes(3) ? 1 : kinds.includes(4) ? 2 : 0;
  const most = Math.max(brightest(lut), 1e-6);
  const gain = quantity === 1 ? (kinds.includes(5) ? 0.04 : 2.0) / most : Math.max(1, (quantity === 2 ? 4 : 0.4) / most);
  return {
    uniforms: {
      ranges: [lut.x.from, lut.x.to, lut.y?.from ?? 0, lut.y?.to ?? 1],
      toRec709: transposed(lut.toRec709),
      hasThrough: hasThrough ? 1 : 0,
      lut: 0,
      lutThrough: 1,
    },
    gain,
    defines: `#define AXIS_X ${kinds[0]}\n#define AXIS_Y ${kinds[1]}\n#define QUANTITY ${quantity}\n`,
  };
}
