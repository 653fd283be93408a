// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// What `generate` writes has no error and no warning in the Khronos validator: every sample scene as a .glb, and some
// scenes, or with the word "all" every one, in both containers and with every option that options.mjs lists.
import validator from 'gltf-validator';
import {readFileSync} from 'node:fs';
import {basename, dirname, join} from 'node:path';
import {generateVariant, strangers, variants} from './options.mjs';
import {awkwardScenes, freshFolder, sampleScenes, scenesIn} from './sweepkit.mjs';

const [program, out, extent] = process.argv.slice(2);
freshFolder(out);

// Textures from files and baked ones, mirrors, glass, instances, awkward names, coordinates far from the origin.
const kSome = ['vase_and_cup', 'semi_transparent', 'awkward'];
const kSeverities = {0: 'error', 1: 'warning'};
let faults = 0;
let files = 0;
const complain = (text) => {
  ++faults;
  console.error(text);
};

async function validate(file) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), {
    uri: basename(file),
    maxIssues: 0,
    externalResourceFunction: async (uri) => new Uint8Array(readFileSync(join(dirname(file), decodeURIComponent(uri)))),
  });
  ++files;
  for (const {severity, code, pointer, message} of report.issues.messages) {
    if (severity in kSeverities) complain(`${file}: ${kSeverities[severity]} ${code} at ${pointer}: ${message}`);
  }
  if (!(report.info.totalTriangleCount > 0)) complain(`${file}: the validator sees no triangle in it`);
}

const {unlisted, unknown} = strangers(program);
unlisted.forEach((option) => complain(`options.mjs does not tell of ${option}`));
unknown.forEach((option) => complain(`options.mjs tells of ${option}, which generate does not have`));
for (const scene of [...scenesIn(sampleScenes), ...scenesIn(awkwardScenes)]) {
  const name = basename(scene, '.json');
  const isWhole = extent === 'all' || kSome.includes(name);
  for (const variant of isWhole ? variants : variants.slice(0, 1)) {
    for (const container of isWhole ? ['glb', 'gltf'] : ['glb']) {
      const file = join(out, `${name}_${variant.name}.${container}`);
      generateVariant(program, scene, file, variant);
      await validate(file);
    }
  }
}
console.log(`${files} files, ${faults} faults`);
process.exit(faults > 0 ? 1 : 0);
