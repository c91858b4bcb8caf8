// How far the page's numbers are from the program's.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { readExr } from "./exr.mjs";
import { build, root, sceneText } from "./module.mjs";

// Not all: the page takes seconds for some, and their kinds are here.
export const parityScenes = [
  "anodised_metal", "any_colour", "beetle", "beetle_stack", "blue_sky", "coated_window", "compact_disc", "jay_feather",
  "jewel_beetle_base", "lacquered_metal", "measured", "morpho", "morpho_tilt", "nacre", "neon_tetra", "oil_film",
  "picked_pair", "soap_film", "tortoise_beetle",
];

/** The largest difference of XYZ between the module and the native session, of all LUTs with one axis. */
export function largestDifference(engine) {
  const program = join(build, "release", "tests", "web", "nacre_session_numbers");
  const scenes = parityScenes.map((name) => join(root, "configs", "scenes", `${name}.toml`));
  const native = JSON.parse(execFileSync(program, scenes, { maxBuffer: 1 << 28 }));
  let largest = 0;
  let numbers = 0;
  let opened = "";
  for (const { scene, lut, xyz } of native) {
    if (scene !== opened) engine.open(sceneText(scene));
    opened = scene;
    const ours = engine.xyz(lut);
    if (ours.length !== xyz.length) throw new Error(`${lut}: ${ours.length / 3} texels, the program has ${xyz.length / 3}`);
    ours.forEach((value, i) => (largest = Math.max(largest, Math.abs(value - xyz[i]))));
    numbers += xyz.length;
  }
  return { largest, numbers, luts: native.length };
}

/** What differs between the page's EXR files and those in luts/, which the program wrote. */
export function fileDifferences(engine) {
  const counted = { files: 0, components: 0, differ: 0, sizes: [], attributes: new Set() };
  for (const scene of parityScenes) {
    for (const { name, y } of engine.open(sceneText(scene)).luts) {
      if (y) continue;
      const ours = readExr(engine.exr(name));
      const theirs = readExr(readFileSync(join(root, "luts", `${name}.exr`)));
      counted.files += 1;
      counted.components += theirs.components.length;
      if (ours.components.length !== theirs.components.length || ours.isHalf !== theirs.isHalf) counted.sizes.push(name);
      theirs.components.forEach((bits, i) => (counted.differ += bits === ours.components[i] ? 0 : 1));
      for (const key of new Set([...Object.keys(ours.attributes), ...Object.keys(theirs.attributes)])) {
        if (!same(ours.attributes[key], theirs.attributes[key])) counted.attributes.add(key);
      }
    }
  }
  return counted;
}

function same(one, other) {
  return one !== undefined && other !== undefined && Buffer.compare(one, other) === 0;
}
