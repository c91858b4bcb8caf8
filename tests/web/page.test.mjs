// The page as its users have it: in Chromium, from a folder, offline.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { bakedOf, openBrowser, openPage, settled, textOf, write } from "./browser.mjs";
import { readExr } from "./exr.mjs";
import { root, sceneText } from "./module.mjs";

let browser;
let page;
before(async () => {
  browser = await openBrowser();
  page = await openPage(browser.context);
});
after(async () => browser.close());

const luts = join(root, "luts");
const numbersOf = (bits, isHalf) =>
  isHalf ? bits.map((half) => halfValue(half)) : [...new Float32Array(new Uint32Array(bits).buffer)];

function halfValue(bits) {
  const sign = bits & 0x8000 ? -1 : 1;
  const exponent = (bits >> 10) & 31;
  const fraction = bits & 1023;
  return sign * (exponent === 0 ? fraction * 2 ** -24 : (1 + fraction / 1024) * 2 ** (exponent - 15));
}

/** Texels of a file of luts/, as the page has them: R, G, B of each. */
function shippedTexels(name) {
  const { components, width, height, isHalf } = readExr(readFileSync(join(luts, `${name}.exr`)));
  const stored = numbersOf(components, isHalf);
  const texels = [];
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) for (const c of [2, 1, 0]) texels.push(stored[(3 * y + c) * width + x]);
  }
  return texels;
}

/** Drags a square of the plane or the palette to numbers of its axes. */
async function dragSquare(square, plot, ranges, to) {
  const from = await square.locator("rect.touch").boundingBox();
  const field = await plot.boundingBox();
  const x = field.x + (field.width * (to.x - ranges.x[0])) / (ranges.x[1] - ranges.x[0]);
  const y = field.y + field.height * (1 - (to.y - ranges.y[0]) / (ranges.y[1] - ranges.y[0]));
  await page.mouse.move(from.x + from.width / 2, from.y + from.height / 2);
  await page.mouse.down();
  await page.mouse.move(x + 9, y - 7, { steps: 4 });
  await page.mouse.move(x, y, { steps: 3 });
  await page.mouse.up();
  await settled(page);
}

async function press(times, more, less) {
  for (let i = 0; i < Math.abs(times); ++i) await page.keyboard.press(times > 0 ? more : less);
}

const plane = () => page.locator("#plane");
const square = (name) => page.getByRole("slider", { name });

describe("the page", () => {
  test("starts with the Morpho of the paper, and asks for nothing but its own files", async () => {
    assert.deepEqual(page.said, []);
    assert.ok(page.asked.every((url) => /^(file|blob|data):/.test(url)), page.asked.join(" "));
    assert.equal(await textOf(page), sceneText("morpho"));
    assert.deepEqual((await bakedOf(page)).texels, shippedTexels("morpho"));
  });

  test("drags both squares from elsewhere to the Morpho's values, and has the texels of its scene", async () => {
    const start = sceneText("morpho").replace("peak_nm = 460", "peak_nm = 600").replace("peak_nm = 395", "peak_nm = 520");
    await write(page, start.replace("width_nm = 70", "width_nm = 150").replace("height = 0.7", "height = 0.3"));
    const field = plane().locator("canvas");
    const ranges = { x: [360, 830], y: [0, 90] };
    await dragSquare(square("Pick 1 of 2"), field, ranges, { x: 460, y: 0 });
    await dragSquare(square("Pick 2 of 2"), field, ranges, { x: 395, y: 40 });
    const palette = page.locator("#palette canvas");
    const widths = async () => ({ x: [0, Number(await palette.getAttribute("data-to-x"))], y: [0, 1] });
    await dragSquare(square("Width and height"), palette, await widths(), { x: 60, y: 0.7 });
    await square("Pick 1 of 2").focus();
    await settled(page);
    await dragSquare(square("Width and height"), palette, await widths(), { x: 70, y: 1 });
    // A pixel is 1 nm or more: what the hand leaves, keys finish.
    const steps = [1, 1, 1, 0.01];
    for (const [i, wanted] of [[0, 460, 70, 1], [40, 395, 60, 0.7]].entries()) {
      await square(`Pick ${i + 1} of 2`).focus();
      const left = await page.evaluate(([pick, numbers, sizes]) => {
        const { angleDeg, peakNm, widthNm, height } = window.nacrePage.material.picks[pick];
        return [angleDeg, peakNm, widthNm, height].map((value, j) => Math.round((numbers[j] - value) / sizes[j]));
      }, [i, wanted, steps]);
      assert.ok(left.every((count) => Math.abs(count) <= 2), `${left}`);
      await press(left[0], "ArrowUp", "ArrowDown");
      await press(left[1], "ArrowRight", "ArrowLeft");
      await square("Width and height").focus();
      await press(left[2], "ArrowRight", "ArrowLeft");
      await press(left[3], "ArrowUp", "ArrowDown");
      await settled(page);
    }
    assert.deepEqual((await bakedOf(page)).texels, shippedTexels("morpho"));
  });

  test("moves squares by keys, one number at a time", async () => {
    await write(page, sceneText("morpho"));
    await square("Pick 1 of 2").focus();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowUp");
    await settled(page);
    assert.match(await textOf(page), /angle_deg = 1, *peak_nm = 462/);
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("ArrowLeft");
    await settled(page);
    assert.deepEqual((await bakedOf(page)).texels, shippedTexels("morpho"));
  });

  test("shows picked colours on its pixels", async () => {
    await write(page, '[material.a]\npicks = [ { angle_deg = 0, colour = "#22aa44" }, { angle_deg = 60, colour = "#8822cc" } ]\n');
    for (const [angle, colour] of [[0, [0x22, 0xaa, 0x44]], [60, [0x88, 0x22, 0xcc]]]) {
      const seen = await page.evaluate((deg) => {
        const { view } = window.nacrePage;
        view.set({ flat: deg });
        view.drawNow();
        const pixel = view.readPixel(view.canvas.clientWidth / 2, view.canvas.clientHeight / 2);
        view.set({ flat: null });
        return pixel;
      }, angle);
      assert.ok(colour.every((component, i) => Math.abs(component - seen[i]) <= 1), `${seen} at ${angle} degrees`);
    }
  });

  test("takes a colour by its field, and says what is dimmed", async () => {
    await write(page, sceneText("morpho"));
    await page.getByLabel("Colour of the pick, #rrggbb").fill("#00ff00");
    await page.keyboard.press("Enter");
    await settled(page);
    assert.match(await textOf(page), /\{ angle_deg = 0, +colour = "#00ff00" \}/);
    await page.getByText(/#00ff00: .*(exact|dimmed)/).waitFor();
    await page.getByLabel("Colour of the pick, #rrggbb").fill("what");
    await page.keyboard.press("Enter");
    await page.getByText('"what" is not a colour').waitFor();
  });

  test("undoes and redoes", async () => {
    await write(page, sceneText("beetle"));
    await write(page, sceneText("morpho"));
    await page.getByRole("button", { name: "Undo" }).click();
    assert.equal(await textOf(page), sceneText("beetle"));
    await page.keyboard.press("Control+Shift+Z");
    assert.equal(await textOf(page), sceneText("morpho"));
  });

  test("keeps the last good scene while the text is wrong, and says where", async () => {
    await write(page, sceneText("morpho"));
    const before = await bakedOf(page);
    if (await page.evaluate(() => document.body.classList.contains("text-folded"))) await page.click("#text-toggle");
    await page.getByLabel("Scene (TOML)").fill(sceneText("morpho").replace("shape = 0.26", "shap = 0.26"));
    await page.getByText(/15:1.*did you mean shape/).first().waitFor();
    assert.deepEqual((await bakedOf(page)).texels, before.texels);
    await page.getByLabel("Scene (TOML)").fill(sceneText("morpho").replace("shape = 0.26", "shape = 0.5"));
    await page.waitForFunction(() => window.nacrePage.material.shape === 0.5);
    await settled(page);
    assert.notDeepEqual((await bakedOf(page)).texels, before.texels);
    await page.click("#text-toggle");
  });

  test("does not touch a wrong text but to correct a value of it", async () => {
    const wrong = sceneText("morpho").replace("shape = 0.26", "shape = 2.6");
    await page.evaluate((text) => window.nacrePage.doc.replace(text), wrong);
    await page.getByRole("button", { name: "Add pick" }).click();
    assert.equal(await textOf(page), wrong);
    await page.evaluate(() => window.nacrePage.doc.set({ "material.morpho.shape": 0.26 }));
    assert.deepEqual(await page.evaluate(() => window.nacrePage.doc.opened.mistakes), []);
    await page.evaluate(() => window.nacrePage.doc.replace("[material.morpho"));
    await page.getByRole("button", { name: "Add pick" }).click();
    assert.equal(await textOf(page), "[material.morpho");
    await write(page, sceneText("morpho"));
  });

  test("undoes picked colours one by one", async () => {
    await write(page, sceneText("morpho"));
    for (const colour of ["#22aa44", "#8822cc"]) {
      await page.getByLabel("Colour of the pick, #rrggbb").fill(colour);
      await page.keyboard.press("Enter");
    }
    await page.getByRole("button", { name: "Undo" }).click();
    assert.match(await textOf(page), /#22aa44/);
    await page.getByRole("button", { name: "Undo" }).click();
    assert.equal(await textOf(page), sceneText("morpho"));
  });

  test("says that a bound is out of reach", async () => {
    await write(page, `${sceneText("beetle_stack")}\n[accuracy]\nmax_de00 = 0.1\nwithout = ["polarisation"]\n`);
    await page.getByText(/cannot be reached; the best is/).first().waitFor();
  });

  test("starts with something to look at, whatever the address holds", async () => {
    for (const hash of ["#AAAA", "#%%%"]) {
      const other = await openPage(browser.context, hash);
      assert.equal(await textOf(other), sceneText("morpho"));
      await other.getByText("holds no scene").waitFor();
      await other.close();
    }
    const wrong = await page.evaluate(async () => {
      const bytes = new Blob(["hello world"]).stream().pipeThrough(new CompressionStream("deflate-raw"));
      const packed = new Uint8Array(await new Response(bytes).arrayBuffer());
      return btoa(String.fromCharCode(...packed)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
    });
    const other = await openPage(browser.context, `#${wrong}`);
    assert.equal(await textOf(other), "hello world");
    assert.equal(await other.evaluate(() => window.nacrePage.baked.name), "morpho");
    await other.close();
  });

  test("has the scene in its address", async () => {
    await write(page, sceneText("oil_film"));
    await page.waitForFunction(() => location.hash.length > 20);
    await page.waitForTimeout(600);
    const other = await openPage(browser.context, await page.evaluate(() => location.hash));
    assert.equal(await textOf(other), sceneText("oil_film"));
    await other.close();
  });

  test("leaves with the files of the program", async () => {
    await write(page, sceneText("beetle_stack"));
    const taken = {};
    for (const name of ["EXR", "Manifest"]) {
      await page.getByRole("button", { name: "Export" }).click();
      const [download] = await Promise.all([
        page.waitForEvent("download"),
        page.getByRole("button", { name: new RegExp(name, "i") }).first().click(),
      ]);
      taken[download.suggestedFilename()] = readFileSync(await download.path());
      await page.keyboard.press("Escape");
    }
    const ours = readExr(taken["beetle_stack.exr"]);
    const theirs = readExr(readFileSync(join(luts, "beetle_stack.exr")));
    assert.deepEqual(ours.components, theirs.components);
    assert.equal(taken["beetle_stack.json"].toString(), readFileSync(join(luts, "beetle_stack.json"), "utf8"));
  });

  test("takes dropped tables and scenes", async () => {
    const drop = (files) =>
      page.evaluate((list) => {
        const data = new DataTransfer();
        for (const { name, text } of list) data.items.add(new File([text], name));
        document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
      }, files);
    const table = "wavelength_nm,0\n380,0.1\n500,0.9\n600,0.2\n780,0.1\n";
    const scene = '[material.own]\nmechanism = "measured"\nfile = "own.csv"\n';
    await drop([{ name: "own.csv", text: table }, { name: "own.toml", text: scene }]);
    await page.waitForFunction(() => window.nacrePage.material?.name === "own");
    await settled(page);
    assert.deepEqual(await page.evaluate(() => window.nacrePage.doc.opened.mistakes), []);
  });

  test("finds a film for the picks, in a worker, and can be stopped", async () => {
    await write(page, '[material.a]\npicks = [ { angle_deg = 0, colour = "#d4a017" }, { angle_deg = 55, colour = "#3c9d9b" } ]\n');
    await page.locator("#search-section").evaluate((section) => (section.open = true));
    await page.getByLabel("Mechanism of the structure").selectOption("stack");
    await page.getByRole("button", { name: "Search", exact: true }).click();
    await page.getByRole("button", { name: "Cancel" }).click();
    await page.getByText("cancelled").waitFor();
    await page.getByLabel("Mechanism of the structure").selectOption("film");
    await page.getByRole("button", { name: "Search", exact: true }).click();
    await page.getByRole("button", { name: "Use this film" }).click({ timeout: 30000 });
    await settled(page);
    assert.equal(await page.evaluate(() => window.nacrePage.material.mechanism), "film");
  });

  test("switches an effect off and on", async () => {
    await write(page, sceneText("beetle_stack"));
    const before = (await bakedOf(page)).texels;
    const box = page.getByRole("switch", { name: /dispersion/ });
    await box.uncheck();
    await settled(page);
    assert.match(await textOf(page), /without = \["dispersion"\]/);
    assert.notDeepEqual((await bakedOf(page)).texels, before);
    await page.getByRole("switch", { name: /dispersion/ }).check();
    await settled(page);
    assert.deepEqual((await bakedOf(page)).texels, before);
  });

  test("changes the bound by its slider", async () => {
    await write(page, sceneText("morpho"));
    await page.getByRole("slider", { name: /Error bound/ }).focus();
    for (let i = 0; i < 6; ++i) await page.keyboard.press("PageUp");
    await settled(page);
    const { maxDe00, reached, width } = await bakedOf(page);
    assert.ok(maxDe00 > 0.1 && reached <= maxDe00 && width < 512, `${maxDe00} ${reached} ${width}`);
  });
});

describe("every mechanism", () => {
  const first = ["palette", "film", "stack", "grating", "crystal", "scatter"];
  for (const mechanism of first) {
    test(`${mechanism}: its tab starts a scene, and every control changes the texels`, async () => {
      await write(page, sceneText(mechanism === "palette" ? "oil_film" : "morpho"));
      await page.getByRole("tab", { name: mechanism }).click();
      const start = page.getByRole("button", { name: `Start a ${mechanism}` });
      if (await start.isVisible()) await start.click();
      await settled(page);
      assert.equal(await page.evaluate(() => window.nacrePage.material.mechanism), mechanism);
      const names = await page.locator("#mechanism-panel").getByRole("slider").evaluateAll((all) =>
        all.filter((one) => one.checkVisibility() && one.tagName === "INPUT").map((one) => one.getAttribute("aria-label") ?? one.labels[0]?.textContent));
      assert.ok(names.length > 0);
      for (const name of names) {
        const before = await textOf(page);
        const slider = page.locator("#mechanism-panel").getByRole("slider", { name: name.trim(), exact: true }).first();
        if (!(await slider.isEnabled())) continue;
        await slider.focus();
        await page.keyboard.press((await slider.inputValue()) === (await slider.getAttribute("max")) ? "PageDown" : "PageUp");
        await page.waitForTimeout(50);
        assert.notEqual(await textOf(page), before, name);
        await settled(page);
        assert.deepEqual(await page.evaluate(() => window.nacrePage.doc.opened.mistakes), [], name);
        await page.evaluate((text) => window.nacrePage.doc.replace(text), before);
      }
      await settled(page);
    });
  }
});

describe("the output window", () => {
  test("draws every object, and another picture after every control", async () => {
    await write(page, sceneText("morpho"));
    const pictures = new Set();
    const look = async () => {
      const seen = await page.evaluate(() => {
        window.nacrePage.view.drawNow();
        return window.nacrePage.view.canvas.toDataURL();
      });
      pictures.add(seen);
    };
    let expected = 0;
    for (const name of ["sphere", "wing", "elytra", "car", "bubble", "disc"]) {
      await page.locator(`#objects input[value=${name}]`).check({ force: true });
      await look();
      assert.equal(pictures.size, ++expected, name);
    }
    await page.locator("#objects input[value=sphere]").check({ force: true });
    for (const name of ["Roughness", "Exposure", "Light around", "Light up"]) {
      await page.locator("#output").getByRole("slider", { name, exact: true }).focus();
      await page.keyboard.press("PageUp");
      await look();
      assert.equal(pictures.size, ++expected, name);
    }
    await page.getByLabel("Environment").uncheck();
    await look();
    assert.equal(pictures.size, ++expected, "environment");
    await page.getByLabel("Environment").check();
    const canvas = await page.locator("#output-canvas").boundingBox();
    await page.mouse.move(canvas.x + canvas.width / 2, canvas.y + canvas.height / 2);
    await page.mouse.wheel(0, -240);
    await look();
    assert.equal(pictures.size, ++expected, "wheel");
  });
});

describe("people who use no mouse", () => {
  test("every control has a name, and Tab reaches it", async () => {
    await write(page, sceneText("morpho"));
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll("button, input, select, textarea, [tabindex], [role=slider]")]
        .filter((one) => one.checkVisibility() && !one.ariaLabel && !one.title && !one.textContent.trim() && !(one.labels?.length > 0) && !one.getAttribute("aria-labelledby"))
        .map((one) => one.outerHTML.slice(0, 120)));
    assert.deepEqual(nameless, []);
    const reached = new Set();
    await page.evaluate(() => document.activeElement?.blur());
    for (let i = 0; i < 80; ++i) {
      await page.keyboard.press("Tab");
      reached.add(await page.evaluate(() => document.activeElement?.outerHTML.slice(0, 200)));
    }
    assert.ok(reached.size > 20, `${reached.size}`);
    assert.deepEqual(page.said, []);
  });
});
