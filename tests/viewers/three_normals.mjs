// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// three.js and the ray tracer draw normal maps under the same light: the pictures differ by no more than kMostDifference
// on average, outside of shadows, which three.js is not asked for. Two controls show that this sees the maps at all: with
// their green turned round, as a wrong direction of v would do, and without them.
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import pngjs from 'pngjs';
import {drawInThree, withThree} from './browser.mjs';
import {awkwardScenes, freshFolder, sweepkit, uncommented} from './sweepkit.mjs';

const {PNG} = pngjs;
const [program, out] = process.argv.slice(2);
freshFolder(out);

// Levels of 255, the mean over the pixels of the objects. What remains is filtering (mip maps there) and frames that are
// interpolated in float32 and made unit at other moments.
const kMostDifference = 4;
// How much worse the controls must be.
const kLeastFactor = 2.5;
const kSize = 512;
const sceneFile = join(awkwardScenes, 'normals.json');
const scene = JSON.parse(uncommented(readFileSync(sceneFile, 'utf8')));

function renderOurs(name, settings) {
  const file = join(out, name);
  sweepkit(program, 'render', sceneFile, '-o', file, '--quiet', '--alpha', ...settings);
  return PNG.sync.read(readFileSync(file));
}

// In levels, over the pixels of the mask.
function difference(ours, theirs, mask) {
  let sum = 0;
  let count = 0;
  for (let pixel = 0; pixel < kSize * kSize; ++pixel) {
    if (!mask[pixel]) continue;
    for (let k = 0; k < 3; ++k) sum += Math.abs(ours.data[4 * pixel + k] - theirs.data[4 * pixel + k]);
    count += 3;
  }
  return sum / count;
}

const glbFile = join(out, 'normals.glb');
sweepkit(program, 'generate', sceneFile, '-o', glbFile, '--quiet');
const [theirs, turned] = await withThree(out, async (page, urlOf) => {
  const request = {url: urlOf('normals.glb'), size: kSize, sun: scene.lights[0].directional};
  return [await drawInThree(page, request), await drawInThree(page, {...request, turnsGreen: true})];
}, 'lit_page.js');
const ours = renderOurs('ours.png', []);
const flat = renderOurs('flat.png', Object.keys(scene.materials).flatMap((name) => ['--set', `/materials/${name}/normal_strength=0`]));
// What is black here and not there lies in a shadow.
const open = Array.from({length: kSize * kSize}, (_, pixel) => ours.data[4 * pixel + 3] === 255 &&
  !(ours.data[4 * pixel] + ours.data[4 * pixel + 1] + ours.data[4 * pixel + 2] < 3 &&
    theirs.data[4 * pixel] + theirs.data[4 * pixel + 1] + theirs.data[4 * pixel + 2] > 60));

const faults = [];
const asDrawn = difference(ours, theirs, open);
console.log(`pixels compared: ${open.filter(Boolean).length}; mean difference ${asDrawn.toFixed(2)} levels`);
if (!(asDrawn <= kMostDifference)) faults.push(`they differ by more than ${kMostDifference} levels`);
for (const [name, a, b] of [['green turned round', ours, turned], ['no maps', flat, theirs]]) {
  const control = difference(a, b, open);
  console.log(`${name}: ${control.toFixed(2)} levels`);
  if (!(control >= kLeastFactor * asDrawn)) faults.push(`with ${name} they differ hardly more`);
}
writeFileSync(join(out, 'three.png'), PNG.sync.write(theirs));
if (faults.length > 0) {
  faults.forEach((fault) => console.error(fault));
  console.error(`the pictures are in ${out}`);
  process.exit(1);
}
