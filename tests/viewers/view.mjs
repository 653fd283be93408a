// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The pages of `sweepkit view`, opened in headless Chromium from file://, in a window and on a phone: no error on the
// console, no request but for the page itself, the screenshots stored in expected/, and every control does what it says.
// Where it fails, the screenshots are left in the folder given; run with SWEEPKIT_STORE_SCREENSHOTS=1 to store them anew.
import {copyFileSync, existsSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import pngjs from 'pngjs';
import {launch, webgl} from './browser.mjs';
import {freshFolder, sampleScenes, sweepkit} from './sweepkit.mjs';

const {PNG} = pngjs;
const here = dirname(fileURLToPath(import.meta.url));
const [program, out] = process.argv.slice(2);
freshFolder(out);

// Levels of 255, on average over all samples. The same Chromium draws the same bits; fonts and versions move edges.
const kMostDifference = 3;
const faults = [];
function expect(holds, what) {
  if (!holds) faults.push(what);
}

async function open(browser, file, options) {
  const page = await browser.newPage({reducedMotion: 'reduce', colorScheme: 'light', ...options});
  page.on('console', (message) => expect(message.type() !== 'error', `${file}: on the console: ${message.text()}`));
  page.on('pageerror', (error) => faults.push(`${file}: ${error}`));
  page.on('request', (request) => {
    const url = request.url();
    expect(/^(data|blob):/.test(url) || url === `file://${file}`, `${file}: asks for ${url}`);
  });
  await page.goto(`file://${file}`);
  await page.waitForFunction(() => document.documentElement.dataset.state !== 'loading', null, {timeout: 60000});
  return page;
}

const state = (page, name = 'state') => page.evaluate((n) => document.documentElement.getAttribute(`data-${n}`), name);

// When two frames have gone by nothing moves any more: the page draws on demand and damping is off.
async function shot(page, clip) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 50)))));
  return PNG.sync.read(await page.screenshot({clip}));
}

// What the panel leaves free: on it the focus and the pointer leave marks.
function modelIn(page) {
  const {width, height} = page.viewportSize();
  return width > 640 ? {x: 0, y: 0, width: width - 290, height} : {x: 0, y: 60, width, height: 0.5 * height - 60};
}

function difference(a, b) {
  if (a.width !== b.width || a.height !== b.height) return 255;
  let sum = 0;
  for (let i = 0; i < a.data.length; ++i) sum += Math.abs(a.data[i] - b.data[i]);
  return sum / a.data.length;
}

async function compareStored(page, name) {
  const picture = await shot(page);
  const made = join(out, name);
  const stored = join(here, 'expected', name);
  writeFileSync(made, PNG.sync.write(picture));
  if (process.env.SWEEPKIT_STORE_SCREENSHOTS) copyFileSync(made, stored);
  if (!existsSync(stored)) return expect(false, `${stored} is missing`);
  const apart = difference(picture, PNG.sync.read(readFileSync(stored)));
  console.log(`${name}: ${apart.toFixed(3)} levels from the stored one`);
  expect(apart <= kMostDifference, `${made} differs from ${stored} by ${apart.toFixed(2)} levels`);
}

// Does `act` change the picture of the model, and, if `undo` is given, that change it back?
async function changes(page, what, act, undo) {
  const clip = modelIn(page);
  const before = await shot(page, clip);
  await act();
  expect(difference(before, await shot(page, clip)) > 0.05, `${what} changes nothing`);
  if (!undo) return;
  await undo();
  const left = difference(before, await shot(page, clip));
  expect(left < 0.01, `${what}: the way back ends elsewhere, by ${left}`);
}

async function exercise(page) {
  const press = (key) => () => page.keyboard.press(key);
  const click = (selector) => () => page.click(selector);
  for (const [look, key] of [['checker', '2'], ['normals', '3'], ['clay', '4']]) {
    await changes(page, `the look ${look}`, click(`#look-${look}`), click('#look-finished'));
    await changes(page, `key ${key}`, press(key), press('1'));
    await page.keyboard.press(key);
    expect(await state(page, 'look') === look, `key ${key} does not choose ${look}`);
    expect(await page.getAttribute(`#look-${look}`, 'aria-pressed') === 'true', `${look} is not shown as chosen`);
    await page.keyboard.press('1');
  }
  await changes(page, 'the button Wireframe', click('#wires'), click('#wires'));
  await changes(page, 'key W', press('w'), press('w'));
  await changes(page, 'the button Curves', click('#curves'), click('#curves'));
  await changes(page, 'key C', press('c'), press('c'));
  await changes(page, 'the button Fit', click('#fit'), click('#reset'));
  await changes(page, 'key F', press('f'), press('r'));
  for (const key of ['ArrowLeft', 'ArrowUp', '+', '-']) await changes(page, `key ${key}`, press(key), press('r'));
  await changes(page, 'the button Light / dark', click('#theme'), click('#theme'));
  expect(await state(page, 'theme') === 'light', 'the theme is not light again');
  await changes(page, 'key T', press('t'), press('t'));
  const boxes = await page.$$('.row input');
  expect(boxes.length === 5, `there are ${boxes.length} objects in the list, not 5`);
  await changes(page, 'the box of the vase', () => boxes[3].click(), () => boxes[3].click());
  const frames = await page.$$('.row button');
  await changes(page, 'the frame of the cup', () => frames[4].click(), press('r'));
  await changes(page, 'the button for the panel', click('#menu'), click('#menu'));
  await changes(page, 'key M', press('m'), press('m'));
  await page.keyboard.press('?');
  expect(await page.isVisible('#help table'), '? shows no keys');
  await page.click('#help button');
  expect(!await page.isVisible('#help table'), 'the keys cannot be closed');
  await changes(page, 'dragging', async () => {
    await page.mouse.move(300, 300);
    await page.mouse.down();
    await page.mouse.move(380, 320, {steps: 4});
    await page.mouse.up();
  }, press('r'));
  await changes(page, 'the wheel', async () => {
    await page.mouse.move(300, 300);
    await page.mouse.wheel(0, 400);
  }, press('r'));
  await page.emulateMedia({colorScheme: 'dark'});
  expect(await state(page, 'theme') === 'light', 'what was chosen does not stay chosen');
}

const scenePage = join(out, 'vase_and_cup.html');
sweepkit(program, 'view', join(sampleScenes, 'vase_and_cup.json'), '-o', scenePage, '--quiet');
const morphPage = join(out, 'star_to_circle.html');
sweepkit(program, 'view', join(sampleScenes, 'star_to_circle.json'), '-o', morphPage, '--quiet');
sweepkit(program, 'generate', join(sampleScenes, 'spring.json'), '-o', join(out, 'spring.glb'), '--quiet');
const modelPage = join(out, 'spring.html');
sweepkit(program, 'view', join(out, 'spring.glb'), '-o', modelPage, '--quiet');
// Both animations and two lights.
sweepkit(program, 'generate', '--contour', 'circle:0.1', '--trajectory', 'helix:radius=1,pitch=0.3,turns=2', '--turntable', '4',
         '--set', '/lights=[{"directional": [0.5, -1, -0.5]}, {"point": [3, 3, 3]}]',
         '--grow', '4', '-o', join(out, 'moving.glb'), '--quiet');
const movingPage = join(out, 'moving.html');
sweepkit(program, 'view', join(out, 'moving.glb'), '-o', movingPage, '--quiet');
// Names that would end the script, the title or the page.
const name = '</script><script>document.title="no"</script><!-- "&amp; \\u003c';
writeFileSync(join(out, 'names.json'), JSON.stringify({sweepkit: 1, objects: [{
  name, sweep: {contour: {circle: {radius: 0.1}}, trajectory: {line: [[0, 0, 0], [0, 1, 0]]}}}]}));
const namesPage = join(out, 'names.html');
sweepkit(program, 'view', join(out, 'names.json'), '--object', name, '-o', namesPage, '--quiet');

// Is it another picture a while later?
async function moves(page) {
  const clip = modelIn(page);
  const before = await shot(page, clip);
  await page.waitForTimeout(400);
  return difference(before, await shot(page, clip)) > 0.05;
}

async function exerciseMotion(page) {
  expect(await state(page, 'lights') === '2', 'the two lights of the file are not seen');
  expect(await state(page, 'playing') === 'false', 'who wants less motion gets some at once');
  expect(!await moves(page), 'what is paused moves');
  for (const [what, act] of [['key P', () => page.keyboard.press('p')], ['the button Play', () => page.click('#play')]]) {
    await act();
    expect(await state(page, 'playing') === 'true' && await page.getAttribute('#play', 'aria-pressed') === 'true', `${what} does not play`);
    expect(await moves(page), `${what}: nothing moves`);
    await act();
    expect(await state(page, 'playing') === 'false' && !await moves(page), `${what} does not pause`);
  }
  expect((await page.$$('.row input')).length === 1, 'the object on the turntable is not in the list');
  await changes(page, 'Wireframe on what has grown in part', () => page.keyboard.press('w'), () => page.keyboard.press('w'));
}

const browser = await launch(webgl);
try {
  const wide = await open(browser, scenePage, {viewport: {width: 800, height: 500}});
  expect(await state(wide) === 'ready', 'the page is not ready');
  await compareStored(wide, 'view_window.png');
  expect(Number(await state(wide, 'lights')) > 0, 'the lights of the file are not seen');
  expect(!await wide.$('#play'), 'a file without animations offers to play them');
  await exercise(wide);

  const phone = await open(browser, morphPage, {viewport: {width: 390, height: 780}, hasTouch: true, isMobile: true});
  expect(!await phone.isVisible('#panel'), 'on a phone the panel covers the model from the start');
  await compareStored(phone, 'view_phone.png');
  await changes(phone, 'tapping the menu', () => phone.tap('#menu'), () => phone.tap('#menu'));
  await phone.tap('#menu');
  await changes(phone, 'tapping Clay', () => phone.tap('#look-clay'), () => phone.tap('#look-finished'));
  const {scroll, inner} = await phone.evaluate(() => ({scroll: document.documentElement.scrollWidth, inner: innerWidth}));
  expect(scroll <= inner, 'on a phone the page is wider than the window');

  const model = await open(browser, modelPage, {viewport: {width: 800, height: 500}});
  expect(await state(model) === 'ready', 'the page of a .glb is not ready');
  expect(await model.isDisabled('#curves'), 'a .glb without curves offers them');

  const moving = await open(browser, movingPage, {viewport: {width: 800, height: 500}});
  expect(await state(moving) === 'ready', 'the page of a .glb with animations is not ready');
  await exerciseMotion(moving);
  const lively = await open(browser, movingPage, {viewport: {width: 800, height: 500}, reducedMotion: 'no-preference'});
  expect(await state(lively, 'playing') === 'true', 'the animations do not play by themselves');

  const names = await open(browser, namesPage, {viewport: {width: 800, height: 500}});
  expect(await state(names) === 'ready', 'the page with strange names is not ready');
  expect(await state(names, 'lights') === '0', 'a file without lights is shown as one with some');
  expect(await names.title() === name, `the title is ${await names.title()}`);
  expect(await names.textContent('.row span') === name, 'the list tells another name');
} finally {
  await browser.close();
}

// Without WebGL the page says so.
const plain = await launch(['--disable-3d-apis']);
try {
  const page = await plain.newPage();
  await page.goto(`file://${modelPage}`);
  await page.waitForFunction(() => document.documentElement.dataset.state !== 'loading');
  expect(await state(page) === 'failed' && /WebGL/.test(await page.textContent('#message')),
         `without WebGL the page says ${await state(page)}: ${await page.textContent('#message')}`);
} finally {
  await plain.close();
}

if (faults.length > 0) {
  faults.forEach((fault) => console.error(fault));
  process.exit(1);
}
