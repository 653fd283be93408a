// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// three.js in headless Chromium draws the generated vase_and_cup.glb with the scene's own camera, and the ray tracer
// draws the scene, both without light. Then
//   - the silhouette of each object overlaps by at least 98 % (intersection over union);
//   - the floor's tiles are in the same places: over the pixels that both call floor, the two pictures correlate by at
//     least kLeastCorrelation, and less when one is moved by a pixel any way.
// Where this fails, both pictures and their difference are left in the folder given.
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import pngjs from 'pngjs';
import {drawInThree, withThree} from './browser.mjs';
import {freshFolder, sampleScenes, sweepkit, uncommented} from './sweepkit.mjs';

const {PNG} = pngjs;
const [program, out] = process.argv.slice(2);
freshFolder(out);

const kLeastOverlap = 0.98;
// The two filter differently - a box over the neighbours here, mip maps there - which shows towards the horizon.
const kLeastCorrelation = 0.95;
const kSize = 512;
const sceneFile = join(sampleScenes, 'vase_and_cup.json');
const scene = JSON.parse(uncommented(readFileSync(sceneFile, 'utf8')));
// A colour for each object; linear 0 and 1 are the same bytes in every encoding, and black is the background.
const cubeCorners = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [1, 0, 1], [0, 1, 1], [1, 1, 1]];
if (scene.objects.length > cubeCorners.length) throw new Error('the scene has more objects than there are clear colours');
const colors = Object.fromEntries(scene.objects.map((object, index) => [object.name, cubeCorners[index]]));

const unlit = ['--set', '/lights=[]', '--set', '/ambient=[1,1,1]', '--set', '/background=[0,0,0]', '--depth', '0'];

function renderOurs(name, settings) {
  const file = join(out, name);
  sweepkit(program, 'render', sceneFile, '-o', file, '--size', `${kSize}x${kSize}`, '--quiet', ...unlit, ...settings);
  return PNG.sync.read(readFileSync(file));
}

// Each object gets a material of its own.
function drawOurObjects() {
  const settings = [];
  scene.objects.forEach((object, index) => {
    settings.push('--set', `/materials/flat ${index}={"diffuse": ${JSON.stringify(colors[object.name])}}`);
    settings.push('--set', `/objects/${index}/material=flat ${index}`);
  });
  return renderOurs('objects_ours.png', settings);
}

function drawTheirs(requests) {
  return withThree(out, async (page, urlOf) => {
    const pictures = [];
    for (const request of requests) pictures.push(await drawInThree(page, {url: urlOf('vase_and_cup.glb'), ...request}));
    return pictures;
  });
}

function isObject(picture, pixel, name) {
  return colors[name].every((value, k) => (picture.data[4 * pixel + k] > 127) === (value === 1));
}

function overlap(ours, theirs, name) {
  let both = 0;
  let either = 0;
  for (let pixel = 0; pixel < kSize * kSize; ++pixel) {
    const a = isObject(ours, pixel, name);
    const b = isObject(theirs, pixel, name);
    both += a && b ? 1 : 0;
    either += a || b ? 1 : 0;
  }
  return either > 0 ? both / either : 0;
}

// Pearson's correlation of brightness over the floor, theirs moved by (dx, dy) pixels.
function correlation(ours, theirs, mask, dx, dy) {
  let n = 0, sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  const grey = (picture, pixel) => picture.data[4 * pixel] + picture.data[4 * pixel + 1] + picture.data[4 * pixel + 2];
  for (let y = 1; y < kSize - 1; ++y) {
    for (let x = 1; x < kSize - 1; ++x) {
      const pixel = y * kSize + x;
      const moved = (y + dy) * kSize + x + dx;
      if (!mask[pixel] || !mask[moved]) continue;
      const a = grey(ours, pixel);
      const b = grey(theirs, moved);
      n += 1, sa += a, sb += b, saa += a * a, sbb += b * b, sab += a * b;
    }
  }
  return (n * sab - sa * sb) / Math.sqrt((n * saa - sa * sa) * (n * sbb - sb * sb));
}

function difference(ours, theirs) {
  const picture = new PNG({width: kSize, height: kSize});
  for (let i = 0; i < picture.data.length; ++i) {
    picture.data[i] = i % 4 === 3 ? 255 : Math.abs(ours.data[i] - theirs.data[i]);
  }
  return picture;
}

sweepkit(program, 'generate', sceneFile, '-o', join(out, 'vase_and_cup.glb'), '--quiet');
const request = {width: kSize, height: kSize, background: [0, 0, 0]};
const theirs = await drawTheirs([{...request, look: 'flat', colors}, {...request, look: 'base'}]);
const noMirrors = Object.keys(scene.materials).flatMap((name) => ['--set', `/materials/${name}/reflect=0`]);
const ours = [drawOurObjects(), renderOurs('textures_ours.png', noMirrors)];

const faults = [];
for (const name of Object.keys(colors)) {
  const share = overlap(ours[0], theirs[0], name);
  console.log(`${name}: silhouettes overlap by ${(100 * share).toFixed(2)} %`);
  if (!(share >= kLeastOverlap)) faults.push(`the silhouettes of "${name}" overlap by less than ${100 * kLeastOverlap} %`);
}
const mask = Array.from({length: kSize * kSize}, (_, pixel) =>
  isObject(ours[0], pixel, 'floor') && isObject(theirs[0], pixel, 'floor'));
const inPlace = correlation(ours[1], theirs[1], mask, 0, 0);
console.log(`floor: the textures correlate by ${inPlace.toFixed(4)}`);
if (!(inPlace >= kLeastCorrelation)) faults.push(`the floors correlate by less than ${kLeastCorrelation}`);
for (const [dx, dy] of [[-1, 0], [1, 0], [0, -1], [0, 1]]) {
  const moved = correlation(ours[1], theirs[1], mask, dx, dy);
  console.log(`floor moved by (${dx}, ${dy}): ${moved.toFixed(4)}`);
  if (!(moved < inPlace)) faults.push(`the floors agree better when moved by (${dx}, ${dy}) pixels`);
}

if (faults.length > 0) {
  ['objects', 'textures'].forEach((name, i) => {
    writeFileSync(join(out, `${name}_three.png`), PNG.sync.write(theirs[i]));
    writeFileSync(join(out, `${name}_difference.png`), PNG.sync.write(difference(ours[i], theirs[i])));
  });
  faults.forEach((fault) => console.error(fault));
  console.error(`the pictures are in ${out}`);
  process.exit(1);
}
