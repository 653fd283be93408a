// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Every sample scene, in both containers and with every option, has no error and no warning in the Khronos validator.
import validator from 'gltf-validator';
import {readFileSync} from 'node:fs';
import {basename, dirname, join} from 'node:path';
import {awkwardScenes, freshFolder, sampleScenes, scenesIn, sweepkit} from './sweepkit.mjs';

const [program, out] = process.argv.slice(2);
freshFolder(out);

const kVariants = [
  ['.glb'],
  ['.gltf'],
  ['_tangents.glb', '--tangents'],
  ['_unlit.glb', '--unlit'],
  ['_compatible.glb', '--compatible'],
  ['_separate.glb', '--images', 'separate', '--image-format', 'jpg'],
  ['_embedded.gltf', '--images', 'embedded', '--max-texture', '16'],
];
const kError = 0;
const kWarning = 1;
let faults = 0;
let files = 0;
for (const scene of [...scenesIn(sampleScenes), ...scenesIn(awkwardScenes)]) {
  for (const [ending, ...more] of kVariants) {
    const file = join(out, basename(scene, '.json') + ending);
    sweepkit(program, 'generate', scene, '-o', file, '--bake-size', '64', '--quiet', ...more);
    const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), {
      uri: basename(file),
      externalResourceFunction: async (uri) => new Uint8Array(readFileSync(join(dirname(file), decodeURIComponent(uri)))),
    });
    ++files;
    for (const message of report.issues.messages) {
      if (message.severity !== kError && message.severity !== kWarning) continue;
      ++faults;
      console.error(`${file}: ${message.code} at ${message.pointer}: ${message.message}`);
    }
    if (!(report.info.totalTriangleCount > 0)) {
      ++faults;
      console.error(`${file}: the validator sees no triangle in it`);
    }
  }
}
console.log(`${files} files, ${faults} errors and warnings`);
process.exit(faults > 0 ? 1 : 0);
