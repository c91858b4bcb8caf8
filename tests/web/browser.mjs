// The built page in Debian's Chromium, from its folder: nothing is served, and the network is off.
import { mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { build, root } from "./module.mjs";

const { chromium } = createRequire(join(root, "src", "web", "package.json"))("playwright-core");

export const address = pathToFileURL(join(build, "page", "index.html")).href;

/** @param sizes  { width, height, deviceScaleFactor, colorScheme } */
export async function openBrowser(sizes = {}) {
  const folder = mkdtempSync(join(tmpdir(), "nacre-page-"));
  const { width = 1280, height = 800, ...rest } = sizes;
  const context = await chromium.launchPersistentContext(folder, {
    executablePath: "/usr/bin/chromium",
    headless: true,
    args: [
      "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    ],
    viewport: { width, height },
    acceptDownloads: true,
    offline: true,
    ...rest,
  });
  const close = async () => {
    await context.close();
    rmSync(folder, { recursive: true, force: true });
  };
  return { context, close };
}

/** The page when it has shown its first scene. What it says on the console is kept in page.said. */
export async function openPage(context, hash = "") {
  const page = await context.newPage();
  page.said = [];
  page.asked = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && page.said.push(message.text()));
  page.on("pageerror", (error) => page.said.push(String(error)));
  page.on("request", (request) => page.asked.push(request.url()));
  await page.goto(address + hash);
  await page.waitForFunction(() => window.nacrePage?.baked);
  await settled(page);
  return page;
}

/** Until the exact answer to the last change is shown. */
export async function settled(page, timeout = 60000) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  await page.waitForFunction(() => !document.body.classList.contains("busy"), undefined, { timeout });
}

/** Opens a text as if it were typed. */
export async function write(page, text) {
  await page.evaluate((written) => window.nacrePage.doc.replace(written), text);
  await settled(page);
}

export const textOf = (page) => page.evaluate(() => window.nacrePage.doc.text);
export const bakedOf = (page) =>
  page.evaluate(() => {
    const { texels, ...rest } = window.nacrePage.baked;
    return { ...rest, texels: [...texels] };
  });
