// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A white-grey floor without highlights, lit by each kind of light, in three.js (NoToneMapping) and by the ray tracer:
// in the middle, where a point light is right by its own rule, the grey levels are the same but for what glTF's
// dielectric mirrors of a light that it scatters (F0 = 0.04, roughness 1): with both N.L and N.V near 1 that is
// 0.25 x 0.04 / d = 0.02 of the diffuse light for d = 0.5, 1.5 levels of 255; a grazing light makes it more.
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import pngjs from 'pngjs';
import {drawInThree, withThree} from './browser.mjs';
import {freshFolder, sweepkit} from './sweepkit.mjs';

const [program, out] = process.argv.slice(2);
freshFolder(out);

const kMostLevels = 4;
const kSize = 65;
const kLights = {
  'directional from above': {directional: [0, -1, 0], intensity: [0.8, 0.8, 0.8]},
  'directional, slanting, coloured': {directional: [1, -1, 0.5], intensity: [1.2, 0.6, 0.3]},
  'point from above': {point: [0, 3, 0], intensity: [0.8, 0.8, 0.8]},
  'point, far and slanting': {point: [300, 400, 0], intensity: [0.9, 0.9, 0.9]},
  'point, near': {point: [0, 1, 1], intensity: [0.7, 0.7, 0.7]},
};

function sceneWith(light) {
  return {
    sweepkit: 1,
    camera: {eye: [0, 4, 0.5], target: [0, 0, 0]},
    lights: [light],
    ambient: [0, 0, 0],
    materials: {grey: {diffuse: [0.5, 0.5, 0.5], specular: [0, 0, 0]}},
    objects: [{name: 'floor', material: 'grey', plane: {size: [2, 2]}}],
  };
}

function middle(picture) {
  const at = 4 * ((kSize >> 1) * kSize + (kSize >> 1));
  return [...picture.data.subarray(at, at + 3)];
}

let faults = 0;
await withThree(out, async (page, urlOf) => {
  for (const [i, [name, light]] of Object.entries(kLights).entries()) {
    const scene = join(out, `scene_${i}.json`);
    writeFileSync(scene, JSON.stringify(sceneWith(light)));
    sweepkit(program, 'render', scene, '-o', join(out, 'ours.png'), '--size', `${kSize}x${kSize}`, '--quiet');
    sweepkit(program, 'generate', scene, '-o', join(out, `scene_${i}.glb`), '--quiet');
    const ours = middle(pngjs.PNG.sync.read(readFileSync(join(out, 'ours.png'))));
    const theirs = middle(await drawInThree(page, {url: urlOf(`scene_${i}.glb`), size: kSize}));
    const apart = Math.max(...ours.map((level, k) => Math.abs(level - theirs[k])));
    console.log(`${name}: ${ours} by the ray tracer, ${theirs} in three.js`);
    if (!(apart <= kMostLevels) || !(Math.max(...ours) > 60)) {
      ++faults;
      console.error(`${name}: ${apart} levels apart`);
    }
  }
}, 'lit_page.js');
process.exit(faults > 0 ? 1 : 0);
