// The module of WebAssembly against the native program, in Node.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { fileDifferences, largestDifference } from "./parity.mjs";
import { sceneNames, sceneText, startModule } from "./module.mjs";

let engine;
before(async () => {
  engine = await startModule();
});

describe("the module", () => {
  test("has the program's numbers to 1e-12", () => {
    const { largest, numbers, luts } = largestDifference(engine);
    console.log(`${luts} LUTs, ${numbers} numbers: at most ${largest} apart`);
    assert.ok(luts > 20);
    assert.ok(largest <= 1e-12, `${largest}`);
  });

  test("writes the program's files, but for last bits and OpenColorIO's way to write a matrix", () => {
    const { files, components, differ, sizes, attributes } = fileDifferences(engine);
    console.log(`${files} files: ${differ} of ${components} components differ; attributes: ${[...attributes].join(" ")}`);
    assert.deepEqual(sizes, []);
    assert.ok(differ <= components / 1000);
    assert.deepEqual([...attributes], ["nacre:colourTransform"]);
  });

  test("opens every shipped scene", () => {
    for (const name of sceneNames()) assert.deepEqual(engine.open(sceneText(name)).mistakes, [], name);
  });

  test("reads a material file as the program does, and says what is wrong with one", () => {
    const put = (name, text) => engine.putFile(name, new TextEncoder().encode(text));
    const film = (index) => `[material.a]\nmechanism = "film"\nindex = "${index}"\nthickness_nm = 400\n`;
    put("glass.yml", 'DATA:\n  - type: tabulated n\n    data: |\n        0.30 1.5\n        0.90 1.5\n');
    assert.deepEqual(engine.open(film("glass.yml")).mistakes, []);
    const fromFile = engine.bake("a").texels;
    engine.open(film("glass.yml").replace('"glass.yml"', "1.5"));
    assert.deepEqual(fromFile, engine.bake("a").texels);
    put("bad.yml", "DATA:\n  - type: tabulated n\n    data: |\n        0.30 x\n");
    assert.match(engine.open(film("bad.yml")).mistakes[0].message, /bad\.yml:4/);
    put("alias.yml", "DATA: &a\n  - *a\n");
    assert.match(engine.open(film("alias.yml")).mistakes[0].message, /alias/);
    put("worse.yml", "DATA: [\n");
    assert.match(engine.open(film("worse.yml")).mistakes[0].message, /worse\.yml:\d: is not YAML/);
  });

  test("throws the program's message and goes on", () => {
    assert.throws(() => engine.bake("nothing"), /no LUT/);
    engine.open(sceneText("morpho"));
    assert.equal(engine.bake("morpho").width, 512);
  });

  test("tells how far a search is", () => {
    engine.open('[material.a]\npicks = [ { angle_deg = 0, colour = "#d4a017" }, { angle_deg = 55, colour = "#3c9d9b" } ]\n');
    let steps = 0;
    const { text } = engine.findStructure("a", "film", () => (steps += 1));
    assert.ok(steps > 10);
    assert.match(text, /mechanism = "film"/);
  });
});

after(() => {
  engine = undefined;
});
