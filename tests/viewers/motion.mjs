// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Animated files have no error and no warning in the Khronos validator; three.js's AnimationMixer shows half of a sweep
// at half the time, everything turned by a quarter at a quarter of it, and the same at the end as at the start.
import {readFileSync, writeFileSync} from 'node:fs';
import {basename, join} from 'node:path';
import {AnimationMixer, Box3, Vector3} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
import validator from 'gltf-validator';
import {freshFolder, sampleScenes, sweepkit} from './sweepkit.mjs';

const [program, out] = process.argv.slice(2);
freshFolder(out);

let faults = 0;
function expect(holds, what) {
  if (holds) return;
  ++faults;
  console.error(what);
}

let files = 0;
for (const sample of ['vase_and_cup', 'spring', 'caps', 'star_to_circle', 'seashell', 'picture_frame', 'mesh_files']) {
  const file = join(out, `${sample}.glb`);
  sweepkit(program, 'generate', join(sampleScenes, `${sample}.json`), '-o', file, '--bake-size', '64', '--quiet', '--turntable', '8',
           ...(sample === 'mesh_files' ? [] : ['--grow', '5']));
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), {uri: basename(file), maxIssues: 20});
  ++files;
  for (const message of report.issues.messages) {
    expect(message.severity > 1, `${file}: ${message.code} at ${message.pointer}: ${message.message}`);
  }
  expect(report.info.animationCount > 0, `${file}: the validator sees no animation`);
}
console.log(`${files} files validated`);

async function load(name, objects, ...options) {
  writeFileSync(join(out, `${name}.json`), JSON.stringify({sweepkit: 1, lights: [], ambient: [1, 1, 1], objects}));
  sweepkit(program, 'generate', join(out, `${name}.json`), '-o', join(out, `${name}.glb`), '--quiet', ...options);
  const bytes = new Uint8Array(readFileSync(join(out, `${name}.glb`)));
  const gltf = await new GLTFLoader().parseAsync(bytes.buffer, '');
  const mixer = new AnimationMixer(gltf.scene);
  for (const clip of gltf.animations) mixer.clipAction(clip).play();
  return {scene: gltf.scene, at: (time) => {
    mixer.setTime(time);
    gltf.scene.updateMatrixWorld(true);
    const box = new Box3();
    gltf.scene.traverse((node) => {
      if (!node.isMesh) return;
      for (let i = 0; i < node.geometry.attributes.position.count; ++i) {
        box.expandByPoint(node.getVertexPosition(i, new Vector3()).applyMatrix4(node.matrixWorld));
      }
    });
    return box;
  }};
}
const near = (a, b, bound) => Math.abs(a - b) <= bound;

const rod = {contour: {circle: {radius: 0.1}}, trajectory: {line: [[0, 0, 0], [0, 2, 0]]}};
const growing = await load('rod', [{name: 'rod', sweep: rod}], '--grow', '4');
for (const time of [0, 1, 2, 3, 3.99]) {
  const height = growing.at(time).max.y;
  console.log(`a rod of 2 m after ${time} of 4 s: ${height.toFixed(6)} m`);
  expect(near(height, time / 2, 1e-5), `a growing rod is ${height} m high after ${time} s`);
}
// A helix of 4 turns, 4 m high: half of it is there when its end is 2 m up, but for 2 % of its diagonal of 4.9 m and
// the section's tilt.
const spring = {contour: {circle: {radius: 0.1}}, trajectory: {helix: {radius: 1, pitch: 1, turns: 4}}};
const winding = await load('spring', [{name: 'spring', sweep: spring}], '--grow', '8');
for (const time of [2, 4, 6]) {
  const height = winding.at(time).max.y;
  console.log(`a helix of 4 m after ${time} of 8 s: ${height.toFixed(3)} m`);
  expect(near(height, time / 2 + 0.1, 0.11), `a growing helix is ${height} m high after ${time} s`);
}
// Two boxes 6 m apart along x, at a place of their own: a quarter turn takes x to -z.
const box = {contour: {rectangle: {width: 1, height: 1}}, trajectory: {line: [[0, 0, 0], [0, 1, 0]]}};
const turning = await load('boxes', [{name: 'boxes', sweep: box, instances: [{translate: [100, 0, 0]}, {translate: [106, 0, 0]}]}],
                           '--turntable', '8');
const start = turning.at(0);
const quarter = turning.at(2);
const end = turning.at(7.9999);
expect(near(start.min.x, 99.5, 1e-4) && near(start.max.x, 106.5, 1e-4), 'at rest the boxes are elsewhere');
expect(near(quarter.min.z, -3.5, 1e-4) && near(quarter.max.z, 3.5, 1e-4) && near(quarter.max.x, 103.5, 1e-4),
       `after a quarter the boxes are at ${JSON.stringify(quarter)}`);
expect(near(end.min.x, start.min.x, 1e-3) && near(end.max.x, start.max.x, 1e-3) && near(end.max.z, start.max.z, 1e-3), 'a turn ends elsewhere');
turning.at(0.8);
console.log(`the turntable after a tenth: ${(2 * Math.acos(turning.scene.getObjectByName('turntable').quaternion.w) * 180 / Math.PI).toFixed(4)} degrees`);
expect(near(2 * Math.acos(turning.scene.getObjectByName('turntable').quaternion.w), Math.PI / 5, 1e-5), 'the turntable does not turn evenly');
process.exit(faults > 0 ? 1 : 0);
