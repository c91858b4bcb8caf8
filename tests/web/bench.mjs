// What the page costs, printed in one run: how large it is, how long a drag takes from the move to the drawn picture,
// how near its numbers are to the program's, and how much slower WebAssembly is than the program.
//
//   node bench.mjs        (called by `./run test-page --bench`)
import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { openBrowser, openPage, write } from "./browser.mjs";
import { build, root, sceneText, startModule } from "./module.mjs";
import { fileDifferences, largestDifference } from "./parity.mjs";

const ms = (seconds) => `${(1e3 * seconds).toFixed(1)} ms`;
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

function sizes() {
  const folder = join(build, "page");
  console.log("size                      bytes   compressed");
  let whole = 0;
  for (const name of readdirSync(folder)) {
    const packed = gzipSync(readFileSync(join(folder, name)), { level: 9 }).length;
    whole += packed;
    console.log(`${name.padEnd(20)} ${String(statSync(join(folder, name)).size).padStart(10)} ${String(packed).padStart(12)}`);
  }
  console.log(`${"together".padEnd(20)} ${" ".repeat(10)} ${String(whole).padStart(12)}   (at most 2 000 000)`);
}

/** Moves one number 60 times, a little each; from the change of the text to the drawn picture. */
async function drag(page, path, from, step) {
  return page.evaluate(
    async ({ path, from, step }) => {
      const { doc, view } = window.nacrePage;
      const times = { update: [], draw: [] };
      for (let i = 0; i < 60; ++i) {
        const start = performance.now();
        doc.set({ [path]: from + step * (i % 30) }, "drag");
        const open = performance.now() - start;
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
        const begin = performance.now();
        view.drawNow();
        times.update.push(Math.max(window.nacrePage.lastUpdateMs, open));
        times.draw.push(performance.now() - begin);
      }
      return times;
    },
    { path, from, step },
  );
}

async function frames() {
  const { context, close } = await openBrowser();
  const page = await openPage(context);
  const cases = [
    ["morpho", "material.morpho.picks[0].peak_nm", 440, 1],
    ["soap_film", "material.soap_film.thickness_nm", 390, 1],
    ["oil_film", "material.oil_film.thickness_nm", 340, 1],
    ["beetle", "material.beetle.picks[0].width_nm", 80, 1],
  ];
  console.log("\ndrag, from the move to the new texture and panels (at most 16 ms), median and 90 % of 60");
  for (const [scene, path, from, step] of cases) {
    await write(page, sceneText(scene));
    const { update, draw } = await drag(page, path, from, step);
    const late = [...update].sort((a, b) => a - b)[Math.floor(0.9 * update.length)];
    console.log(`${scene.padEnd(20)} ${ms(median(update) / 1e3).padStart(10)} ${ms(late / 1e3).padStart(10)}   picture handed to the GPU in ${ms(median(draw) / 1e3)}`);
  }
  await close();
}

/** The same LUTs in the module and in the program, in pairs. */
function speed(engine) {
  console.log("\ntime of one LUT             page     program    ratio");
  const program = join(build, "release", "src", "cli", "nacre");
  for (const scene of ["morpho", "beetle_stack", "tortoise_beetle", "jay_feather"]) {
    const path = join(root, "configs", "scenes", `${scene}.toml`);
    const plan = ["bake", path, "--json", "--no-preview", "-o", join(build, "page-tests", "out"), "--force", "--threads", "1"];
    const text = sceneText(scene);
    const ours = [];
    const theirs = [];
    let name = "";
    for (let i = 0; i < 5; ++i) {
      engine.open(`${text}\n# ${i}`);
      name = engine.open(`${text}\n# ${i}`).luts[0].name;
      const { deciding, computing, measuring } = engine.bake(name).seconds;
      ours.push(deciding + computing + measuring);
      const answer = JSON.parse(execFileSync(program, [...plan, "--only", name], { stdio: ["ignore", "pipe", "ignore"] }));
      theirs.push(secondsOf(answer, name));
    }
    const [page, native] = [median(ours), median(theirs)];
    console.log(`${name.padEnd(20)} ${ms(page).padStart(12)} ${ms(native).padStart(11)} ${(page / native).toFixed(1).padStart(8)}`);
  }
}

function secondsOf(answer, name) {
  const { seconds } = answer.luts.find((one) => one.lut === name);
  return seconds.deciding + seconds.computing + seconds.measuring;
}

sizes();
await frames();
const engine = await startModule();
const { largest, numbers, luts } = largestDifference(engine);
console.log(`\nparity: ${numbers} numbers of ${luts} LUTs, at most ${largest.toExponential(1)} apart (at most 1e-12)`);
const { files, components, differ } = fileDifferences(engine);
console.log(`files:  ${differ} of ${components} components of ${files} EXR files differ in their last bit`);
speed(engine);
