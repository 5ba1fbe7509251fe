// SPDX-License-Identifier: Apache-2.0
// Shared by the tests: small runs, the page of each, and a browser that opens the pages.

import {execFileSync, spawnSync} from 'node:child_process';
import {existsSync, mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';

export const PROGRAM = process.env.RIPRAP_PROGRAM;

/** The Chromium that `riprap render` would take; undefined where there is none. */
export function browserProgram() {
  const named = process.env.RIPRAP_CHROMIUM;
  const folders = process.env.PATH.split(':');
  const names = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'];
  const found = folders.flatMap(folder => names.map(name => join(folder, name))).find(path => existsSync(path));
  return named || found;
}

export function riprap(args, options = {}) {
  const {status, stdout, stderr} = spawnSync(PROGRAM, args, {encoding: 'utf8', ...options});
  return {status, stdout, stderr};
}

export function openBrowser() {
  return chromium.launch({
    executablePath: browserProgram(),
    args: ['--disable-gpu', '--enable-unsafe-swiftshader', ...(process.getuid() === 0 ? ['--no-sandbox'] : [])],
  });
}

export class Stage {
  static async open() {
    const stage = new Stage();
    stage.folder = mkdtempSync(join(tmpdir(), 'riprap-page-'));
    stage.browser = await openBrowser();
    return stage;
  }

  async close() {
    await this.browser.close();
    rmSync(this.folder, {recursive: true});
  }

  /** Runs a case and returns its folder. Missed expectations are not the page's concern. */
  run(name, caseName, settings) {
    const out = join(this.folder, name);
    const {status, stderr} = riprap(['run', caseName, '--out', out, '--quiet', '--threads', '1',
                                     ...settings.flatMap(setting => ['--set', setting])]);
    if (status !== 0 && status !== 1) {
      throw new Error(`the run ended with ${status}: ${stderr}`);
    }
    return out;
  }

  /** The page of a run, opened; `requests` is everything that it asked for. */
  async visit(run, {width = 1280, height = 720} = {}) {
    execFileSync(PROGRAM, ['view', run], {stdio: ['ignore', 'ignore', 'ignore']});
    const page = await this.browser.newPage({viewport: {width, height}});
    page.setDefaultTimeout(120_000);
    page.requests = [];
    page.errors = [];
    page.on('request', request => page.requests.push(request.url()));
    page.on('pageerror', error => page.errors.push(error.message));
    page.address = pathToFileURL(join(run, 'index.html')).href;
    await page.goto(page.address);
    await page.waitForFunction(() => document.documentElement.dataset.opened);
    return page;
  }
}

/**
 * The drawn scene: how many pixels differ from the empty background, and the colour at places of the page.
 * Drawn and read at once, before the browser gives the buffer away.
 */
export function lookAt(page, places = []) {
  return page.evaluate(wanted => {
    const {scene} = window.riprap, gl = scene.renderer.getContext();
    scene.draw();
    const {drawingBufferWidth: width, drawingBufferHeight: height} = gl;
    const pixels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const box = scene.canvas.getBoundingClientRect();
    const at = (x, y) => [...pixels.subarray(4 * (y * width + x), 4 * (y * width + x) + 3)];
    const background = at(2, height - 3);
    let drawn = 0;
    for (let k = 0; k < pixels.length; k += 4) {
      const d = Math.abs(pixels[k] - background[0]) + Math.abs(pixels[k + 1] - background[1]) +
                Math.abs(pixels[k + 2] - background[2]);
      drawn += d > 12 ? 1 : 0;
    }
    return {
      share: drawn / (width * height),
      colours: wanted.map(([x, y]) => at(Math.round((x - box.left) * width / box.width),
                                         height - 1 - Math.round((y - box.top) * height / box.height))),
      background,
    };
  }, places);
}

export const differs = (a, b) => a.some((value, k) => Math.abs(value - b[k]) > 12);

/** A CSV file of a run as rows of {name: text}, without units. */
export function table(text) {
  const [heading, ...lines] = text.trim().split('\n');
  const names = heading.split(',').map(name => name.replace(/ \[.*\]$/, ''));
  return lines.map(line => Object.fromEntries(line.split(',').map((field, k) => [names[k], field])));
}
