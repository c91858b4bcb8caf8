// Bundles the page: index.html and page.js, which has everything in it. Called by `./run page`.
//
//   node build.mjs MODULE_FOLDER CONFIGS_FOLDER OUTPUT_FOLDER

import { build } from "esbuild";
import { copyFile, mkdir, readdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const page = join(here, "page");

/** The scenes of configs/scenes with the tables that they name; scenes that name others by include are left out. */
async function shippedScenes(folder) {
  const scenes = [];
  for (const file of (await readdir(folder)).filter((name) => name.endsWith(".toml")).sort()) {
    const text = await readFile(join(folder, file), "utf8");
    if (/^include\s*=/m.test(text)) continue;
    const files = {};
    for (const [, name] of text.matchAll(/"([^"]+\.(?:csv|yml))"/g)) {
      files[name] = await readFile(join(folder, name), "utf8");
    }
    const title = text.match(/^# (.+?)(?:[.:]|$)/m)?.[1] ?? file;
    scenes.push({ name: file.replace(/\.toml$/, ""), title, text, files });
  }
  return scenes;
}

/** The bundle's names for what is no source: see page/bundled.d.ts. */
function bundled(moduleFolder, scenes, workerScript) {
  const contents = {
    "nacre-wasm": async () => ({ contents: await readFile(join(moduleFolder, "nacre_web.wasm")), loader: "binary" }),
    "nacre-scenes": async () => ({ contents: JSON.stringify(scenes), loader: "json" }),
    "nacre-worker": async () => ({ contents: workerScript, loader: "text" }),
  };
  return {
    name: "bundled",
    setup(context) {
      context.onResolve({ filter: /^nacre-module$/ }, () => ({ path: join(moduleFolder, "nacre_web.js") }));
      context.onResolve({ filter: /^nacre-/ }, ({ path }) => ({ path, namespace: "bundled" }));
      context.onLoad({ filter: /.*/, namespace: "bundled" }, ({ path }) => contents[path]());
    },
  };
}

/** @param globalName  gives the bundle's exports a name: for tests */
export async function bundle(entry, moduleFolder, scenes, workerScript, options = {}) {
  const result = await build({
    entryPoints: [entry],
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2022",
    write: false,
    // Emscripten's loader asks for these under Node only.
    external: ["fs", "path", "crypto", "perf_hooks"],
    plugins: [bundled(moduleFolder, scenes, workerScript)],
    logLevel: "warning",
    ...options,
  });
  return result.outputFiles[0].text;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [moduleFolder, configs, output] = process.argv.slice(2);
  const scenes = await shippedScenes(join(configs, "scenes"));
  const worker = await bundle(join(page, "worker.ts"), moduleFolder, [], "");
  await mkdir(output, { recursive: true });
  const banner = { js: `/*! nacre, Apache License 2.0. It contains GLM, Highway, toml++, nlohmann_json, Eigen, Ceres, xxHash, Imath,
the runtime of Emscripten, and yaml:

${await readFile(join(here, "node_modules", "yaml", "LICENSE"), "utf8")}*/` };
  const script = await bundle(join(page, "main.ts"), moduleFolder, scenes, worker, { banner });
  await writeFile(join(output, "page.js"), script);
  for (const file of ["index.html", "style.css"]) await copyFile(join(page, file), join(output, file));
}
