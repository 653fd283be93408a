// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// three.js draws a scene that lies 10,000 km from the origin along each axis as sharply as one at the origin, with the
// file's camera moved along: float32 positions there would be a metre apart. And it draws the same bytes of a picture
// from a .gltf whose name, and so its files' URIs, has to be percent-encoded; the validator finds nothing in it.
import validator from 'gltf-validator';
import {readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import pngjs from 'pngjs';
import {drawInThree, withThree} from './browser.mjs';
import {freshFolder, sampleScenes, sweepkit, uncommented} from './sweepkit.mjs';

const {PNG} = pngjs;
const [program, out] = process.argv.slice(2);
freshFolder(out);

const kFar = 1e7;
// Coordinates in double are 2e-9 m apart there, far under a pixel. Only a pixel whose middle is that near to an edge, or
// whose texture lookup rounds the other way, may change: on average at most a hundredth of a level of 255.
const kMostMeanDifference = 0.01;
const kName = 'Käse & Brot #1 50% +ö';

const sceneFile = join(sampleScenes, 'vase_and_cup.json');
const scene = JSON.parse(uncommented(readFileSync(sceneFile, 'utf8')));
const moved = (point) => JSON.stringify(point.map((value) => value + kFar));
const far = [
  `/camera/eye=${moved(scene.camera.eye)}`, `/camera/target=${moved(scene.camera.target)}`,
  ...scene.objects.map(({translate = [0, 0, 0]}, index) => `/objects/${index}/translate=${moved(translate)}`),
].flatMap((setting) => ['--set', setting]);

const files = {near: 'near.glb', far: 'far.glb', named: `${kName}.gltf`};
sweepkit(program, 'generate', sceneFile, '-o', join(out, files.near), '--quiet', '--unlit');
sweepkit(program, 'generate', sceneFile, '-o', join(out, files.far), '--quiet', '--unlit', ...far);
sweepkit(program, 'generate', sceneFile, '-o', join(out, files.named), '--quiet', '--unlit');

let faults = 0;
const complain = (text) => {
  ++faults;
  console.error(text);
};
const pictures = await withThree(out, async (page, urlOf) => {
  const drawn = {};
  for (const [name, file] of Object.entries(files)) {
    drawn[name] = await drawInThree(page, {url: urlOf(file), width: 512, height: 512, background: [0.5, 0.5, 0.5]});
    writeFileSync(join(out, `${name}.png`), PNG.sync.write(drawn[name]));
  }
  return drawn;
});

let sum = 0;
let most = 0;
let changed = 0;
for (let i = 0; i < pictures.near.data.length; i += 4) {
  const apart = Math.max(...[0, 1, 2].map((k) => Math.abs(pictures.near.data[i + k] - pictures.far.data[i + k])));
  sum += apart;
  most = Math.max(most, apart);
  changed += apart > 0 ? 1 : 0;
}
const pixels = pictures.near.data.length / 4;
console.log(`1e7 m away: ${(sum / pixels).toFixed(5)} levels on average, at most ${most}, ${changed} of ${pixels} pixels changed`);
if (!(sum / pixels <= kMostMeanDifference)) complain('the picture far from the origin is another');

if (!pictures.named.data.equals(pictures.near.data)) complain(`${files.named} is drawn otherwise`);
const report = await validator.validateBytes(new Uint8Array(readFileSync(join(out, files.named))), {
  externalResourceFunction: async (uri) => new Uint8Array(readFileSync(join(out, decodeURIComponent(uri)))),
});
if (report.issues.numErrors + report.issues.numWarnings > 0) complain(JSON.stringify(report.issues.messages));
console.log(`${files.named}: with ${readdirSync(out).filter((name) => name.startsWith(kName)).length - 1} files beside it`);
process.exit(faults > 0 ? 1 : 0);
