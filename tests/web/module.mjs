// The page's module in Node: the same WebAssembly and the same TypeScript as in the browser.
import { createRequire } from "node:module";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

export const root = process.env.NACRE_ROOT;
export const build = process.env.NACRE_BUILD;
const scenesFolder = join(root, "configs", "scenes");

export function sceneNames() {
  return readdirSync(scenesFolder)
    .filter((name) => name.endsWith(".toml"))
    .map((name) => name.replace(/\.toml$/, ""));
}

export function sceneText(name) {
  return readFileSync(join(scenesFolder, `${name}.toml`), "utf8");
}

/** An engine with the tables of the shipped scenes in its file system. */
export async function startModule() {
  const fromPage = createRequire(join(root, "src", "web", "package.json"));
  const { build: bundle } = fromPage("esbuild");
  const outfile = join(build, "page-tests", "module.cjs");
  await bundle({
    entryPoints: [join(root, "src", "web", "page", "module.ts")],
    bundle: true,
    platform: "node",
    format: "cjs",
    outfile,
    logLevel: "warning",
  });
  const { makeEngine } = await import(pathToFileURL(outfile));
  const moduleFolder = join(build, "web", "src", "web");
  const create = fromPage(join(moduleFolder, "nacre_web.js"));
  const files = {};
  for (const name of readdirSync(scenesFolder).filter((file) => file.endsWith(".csv"))) {
    files[name] = readFileSync(join(scenesFolder, name), "utf8");
  }
  return makeEngine(create, readFileSync(join(moduleFolder, "nacre_web.wasm")), [{ files }]);
}
