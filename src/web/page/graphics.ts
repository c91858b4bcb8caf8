// What the output window needs of WebGL 2: programs, meshes, and the LUT as a texture.

import type { Axis, BakedLut } from "./api";
import type { Mesh } from "./surfaces";

export type Uniforms = Record<string, number | number[]>;
/** Makes a program the one that draws, with uniforms by name: numbers of a matrix go column by column. */
export type Use = (uniforms: Uniforms) => void;

export function program(gl: WebGL2RenderingContext, vertex: string, fragment: string): Use {
  const made = gl.createProgram()!;
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
    const shader = gl.createShader(kind)!;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS) && !gl.isContextLost()) {
    throw new Error((gl.getAttachedShaders(made) ?? []).map((shader) => gl.getShaderInfoLog(shader)).join("\n"));
  }
  const count = (gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS) ?? 0) as number;
  const places = Array.from({ length: count }, (_, i) => {
    const { name, type } = gl.getActiveUniform(made, i)!;
    return { name, type, place: gl.getUniformLocation(made, name) };
  });
  return (uniforms) => {
    gl.useProgram(made);
    for (const { name, type, place } of places) {
      const value = [uniforms[name] ?? 0].flat();
      if (type === gl.SAMPLER_2D) gl.uniform1i(place, value[0]!);
      else if (type === gl.FLOAT) gl.uniform1fv(place, value);
      else if (type === gl.FLOAT_VEC2) gl.uniform2fv(place, value);
      else if (type === gl.FLOAT_VEC3) gl.uniform3fv(place, value);
      else if (type === gl.FLOAT_VEC4) gl.uniform4fv(place, value);
      else if (type === gl.FLOAT_MAT2) gl.uniformMatrix2fv(place, false, value);
      else if (type === gl.FLOAT_MAT3) gl.uniformMatrix3fv(place, false, value);
      else gl.uniformMatrix4fv(place, false, value);
    }
  };
}

/** Uploads a mesh; the result draws it. */
export function drawn(gl: WebGL2RenderingContext, mesh: Mesh): () => void {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(mesh.vertices), gl.STATIC_DRAW);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(mesh.indices), gl.STATIC_DRAW);
  for (const [index, [size, offset]] of ([[3, 0], [3, 12], [1, 24], [4, 28]] as const).entries()) {
    gl.enableVertexAttribArray(index);
    gl.vertexAttribPointer(index, size, gl.FLOAT, false, 44, offset);
  }
  return () => {
    gl.bindVertexArray(array);
    gl.drawElements(gl.TRIANGLES, mesh.indices.length, gl.UNSIGNED_INT, 0);
    gl.bindVertexArray(null);
  };
}

/** A LUT that is wider than this machine's textures may be, with every other texel; the file has them all. */
function narrowed({ width, height, texels }: BakedLut, most: number): Pick<BakedLut, "width" | "height" | "texels"> {
  if (width <= most) return { width, height, texels };
  const narrow = new Float32Array(most * height * 3);
  for (let i = 0; i < most * height; ++i) {
    const from = Math.floor(i / most) * width + Math.round(((i % most) * (width - 1)) / (most - 1));
    for (let c = 0; c < 3; ++c) narrow[3 * i + c] = texels[3 * from + c]!;
  }
  return { width: most, height, texels: narrow };
}

/** Linear, clamped, without mip-maps, as luts/README.md asks; half floats where floats cannot be filtered. */
export function uploadLut(gl: WebGL2RenderingContext, unit: number, lut: BakedLut): WebGLTexture {
  const { width, height, texels } = narrowed(lut, gl.getParameter(gl.MAX_TEXTURE_SIZE) as number);
  const format = gl.getExtension("OES_texture_float_linear") ? gl.RGB32F : gl.RGB16F;
  const texture = gl.createTexture()!;
  gl.activeTexture(gl.TEXTURE0 + unit);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, gl.RGB, gl.FLOAT, texels);
  const set = (name: number, value: number): void => gl.texParameteri(gl.TEXTURE_2D, name, value);
  for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) set(filter, gl.LINEAR);
  for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) set(wrap, gl.CLAMP_TO_EDGE);
  return texture;
}

/** Axes as coordinate() in shaders.ts knows them; 7 is any other parameter. */
const kinds = ["sqrt_cos_theta", "cos_theta", "theta_deg", "grating_u", "cos_scatter", "azimuth_deg", "roughness"];
const kindOf = (axis?: Axis): number => (kinds.indexOf(axis?.name ?? "") + 8) % 8;

/** What the shaders have to know of a LUT. `gain` makes dark films and gratings as bright as other materials. */
export function describe(lut: BakedLut, hasThrough: boolean): { uniforms: Uniforms; gain: number; defines: string } {
  const [x, y] = [kindOf(lut.x), kindOf(lut.y)];
  const quantity = x === 3 || y === 3 ? 1 : x === 4 || y === 4 ? 2 : 0;
  const most = Math.max(lut.texels.reduce((a, b) => Math.max(a, b), 0), 1e-6);
  const gain = quantity === 1 ? (y === 5 ? 0.04 : 2.0) / most : Math.max(1, (quantity === 2 ? 4 : 0.4) / most);
  return {
    uniforms: {
      ranges: [lut.x.from, lut.x.to, lut.y?.from ?? 0, lut.y?.to ?? 1],
      toRec709: [0, 3, 6, 1, 4, 7, 2, 5, 8].map((i) => lut.toRec709[i]!),
      hasThrough: hasThrough ? 1 : 0,
      lut: 0,
      lutThrough: 1,
    },
    gain,
    defines: `#define AXIS_X ${x}\n#define AXIS_Y ${y}\n#define QUANTITY ${quantity}\n`,
  };
}
