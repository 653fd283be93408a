// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Picture against picture: what three.js draws of the --unlit .glb of a sample, with the file's own camera and
// materials, against what `sweepkit render` draws of the scene with an ambient light of 1 and no other, which is
// each surface's own colour. By default the samples of kUsual, with the word "all" every sample.
//   - mean FLIP at most kMostFlip;
//   - silhouettes overlap by at least kLeastOverlap (intersection over union): all that is drawn, and the objects that
//     are no planes, which are in front.
// Glass that absorbs is drawn a second time with its colour, of which one alpha for red, green and blue and one thickness for
// a whole body can only say so much: at most kMostTintedFlip.
// One sample a pixel on both sides, so that a pixel is in a silhouette or not. Pictures are left in the folder given.
import {execFileSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {basename, join} from 'node:path';
import pngjs from 'pngjs';
import {drawInThree, withThree} from './browser.mjs';
import {freshFolder, sampleScenes, scenesIn, sweepkit, uncommented} from './sweepkit.mjs';

const {PNG} = pngjs;
const [program, out, meanFlip, extent] = process.argv.slice(2);
freshFolder(out);

const kMostFlip = 0.05;
// Measured: 0.0725 for semi_transparent, of which 0.0278 are its floor's; 0.1128 where blended glass was made to be right
// over white.
const kMostTintedFlip = 0.08;
const kLeastOverlap = 0.99;
const kUsual = ['vase_and_cup', 'moebius_band', 'rope', 'seashell', 'semi_transparent', 'texture_coordinates'];
const kBackground = [0.5, 0.5, 0.5];

// A wall between two media shows as the file's blended one does where it neither mirrors nor bends.
function plainLook(scene, isTinted) {
  const settings = ['/lights=[]', '/ambient=[1,1,1]', `/background=${JSON.stringify(kBackground)}`];
  for (const [name, material] of Object.entries(scene.materials ?? {})) {
    const {diffuse = [0.8, 0.8, 0.8], texture, transmit = 0, absorption} = material;
    const plain = {diffuse, transmit, ...(texture && {texture}), ...(isTinted && absorption && {absorption})};
    settings.push(`/materials/${name}=${JSON.stringify(plain)}`);
  }
  return settings.flatMap((setting) => ['--set', setting]);
}

// Planes black, all else white.
function flatLook(scene, colors) {
  const settings = ['/lights=[]', '/ambient=[1,1,1]', '/background=[0,0,0]'];
  scene.objects.forEach((object, index) => {
    settings.push(`/materials/flat ${index}={"diffuse": ${JSON.stringify(colors[object.name])}}`, `/objects/${index}/material=flat ${index}`);
  });
  return settings.flatMap((setting) => ['--set', setting]);
}

function renderOurs(sceneFile, name, settings) {
  const file = join(out, name);
  sweepkit(program, 'render', sceneFile, '-o', file, '--quiet', ...settings);
  return PNG.sync.read(readFileSync(file));
}

function overlap(a, b, isIn) {
  let both = 0;
  let either = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    const isInA = isIn(a.data, i);
    const isInB = isIn(b.data, i);
    both += isInA && isInB ? 1 : 0;
    either += isInA || isInB ? 1 : 0;
  }
  return either > 0 ? both / either : 1;
}

async function flipOf(page, request, sceneFile, name, look) {
  sweepkit(program, 'generate', sceneFile, '-o', join(out, `${basename(sceneFile, '.json')}.glb`), '--quiet', '--unlit', ...look);
  const theirs = await drawInThree(page, {...request, background: kBackground});
  const theirFile = join(out, `${name}_three.png`);
  writeFileSync(theirFile, PNG.sync.write(theirs));
  renderOurs(sceneFile, `${name}_ours.png`, look);
  return Number(execFileSync(meanFlip, [join(out, `${name}_ours.png`), theirFile], {encoding: 'utf8'}));
}

let faults = 0;
await withThree(out, async (page, urlOf) => {
  console.log('sample, mean FLIP, overlap of all, overlap of what stands before planes');
  for (const sceneFile of scenesIn(sampleScenes)) {
    const name = basename(sceneFile, '.json');
    if (extent !== 'all' && !kUsual.includes(name)) continue;
    const scene = JSON.parse(uncommented(readFileSync(sceneFile, 'utf8')));
    const {width = 512, height = 512} = scene.camera ?? {};
    const colors = Object.fromEntries(scene.objects.map((object) => [object.name, object.plane ? [0, 0, 0] : [1, 1, 1]]));
    const request = {url: urlOf(`${name}.glb`), width, height};
    if (Object.values(scene.materials ?? {}).some(({absorption}) => absorption)) {
      const tinted = await flipOf(page, request, sceneFile, `${name}_tinted`, plainLook(scene, true));
      console.log(`${name}, tinted glass: ${tinted.toFixed(4)}`);
      if (!(tinted <= kMostTintedFlip)) ++faults, console.error(`${name}, tinted: mean FLIP is over ${kMostTintedFlip}`);
    }
    const flip = await flipOf(page, request, sceneFile, name, plainLook(scene, false));
    const flat = flatLook(scene, colors);
    const ourShape = renderOurs(sceneFile, `${name}_shape.png`, [...flat, '--alpha']);
    const theirShape = await drawInThree(page, {...request, look: 'flat', colors});
    const whole = overlap(ourShape, theirShape, (data, i) => data[i + 3] > 127);
    const front = overlap(ourShape, theirShape, (data, i) => data[i + 3] > 127 && data[i] > 127);
    console.log(`${name}, ${flip.toFixed(4)}, ${(100 * whole).toFixed(2)} %, ${(100 * front).toFixed(2)} %`);
    if (!(flip <= kMostFlip)) ++faults, console.error(`${name}: mean FLIP is over ${kMostFlip}`);
    if (!(Math.min(whole, front) >= kLeastOverlap)) ++faults, console.error(`${name}: silhouettes overlap by less than ${100 * kLeastOverlap} %`);
  }
});
process.exit(faults > 0 ? 1 : 0);
