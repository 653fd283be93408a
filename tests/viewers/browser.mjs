// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
import {buildSync} from 'esbuild';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {dirname, extname, join} from 'node:path';
import {chromium} from 'playwright-core';
import pngjs from 'pngjs';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));

/** WebGL by SwiftShader: the same bits on every machine. */
export const webgl = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

/** Chromium without a screen that asks the network for nothing. */
export function launch(more) {
  return chromium.launch({
    executablePath: execFileSync('sh', ['-c', 'command -v chromium'], {encoding: 'utf8'}).trim(),
    args: ['--no-sandbox', '--disable-background-networking', '--disable-component-update', '--disable-default-apps',
           '--disable-sync', '--no-first-run', '--no-pings', ...more],
  });
}

const kOrigin = 'http://files.test';
const kTypes = {'.glb': 'model/gltf-binary', '.gltf': 'model/gltf+json', '.png': 'image/png', '.jpg': 'image/jpeg'};

/**
 * Runs `use(page, urlOf)` on a page with the functions of three_page.js, or another such script. The page sees the files of `folder` as a
 * server's: urlOf(name) is one's address. What goes wrong in the page is thrown.
 */
export async function withThree(folder, use, pageScript = 'three_page.js') {
  const script = buildSync({
    entryPoints: [join(here, pageScript)], bundle: true, write: false, format: 'iife', logLevel: 'error',
  }).outputFiles[0].text;
  const browser = await launch(webgl);
  try {
    const page = await browser.newPage();
    const errors = [];
    page.on('pageerror', (error) => errors.push(String(error)));
    page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
    await page.route('**/*', (route) => {
      const url = new URL(route.request().url());
      if (url.origin !== kOrigin) return route.abort();
      if (url.pathname === '/') return route.fulfill({contentType: 'text/html', body: '<!doctype html><title>three.js</title><link rel="icon" href="data:,">'});
      const name = decodeURIComponent(url.pathname.slice(1));
      try {
        return route.fulfill({contentType: kTypes[extname(name)] ?? 'application/octet-stream', body: readFileSync(join(folder, name))});
      } catch {
        return route.fulfill({status: 404, body: ''});
      }
    });
    await page.goto(kOrigin + '/');
    await page.addScriptTag({content: script});
    const result = await use(page, (name) => `${kOrigin}/${encodeURIComponent(name)}`);
    if (errors.length > 0) throw new Error('in the page: ' + errors.join('; '));
    return result;
  } finally {
    await browser.close();
  }
}

/** What the page's draw() draws for `request`, as a decoded picture. */
export async function drawInThree(page, request) {
  const url = await page.evaluate((given) => window.draw(given), request);
  return pngjs.PNG.sync.read(Buffer.from(url.slice(url.indexOf(',') + 1), 'base64'));
}
