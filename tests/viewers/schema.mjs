// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The schema is itself sound, every sample scene is valid by it, and it refuses every scene that the reader's own
// tests (tests/scene/scene_faults_test.cpp) have refused, but for those whose fault a schema cannot see: these are
// listed here by what is told of them, and none that is listed may be refused after all.
import Ajv from 'ajv/dist/2020.js';
import {execFileSync} from 'node:child_process';
import {readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import {awkwardScenes, freshFolder, sampleScenes, scenesIn, uncommented} from './sweepkit.mjs';

const [program, out, faultsTest] = process.argv.slice(2);
freshFolder(out);

const kUnseen = [  // names, numbers and points that depend on others
  /there is no (texture|material) "/,
  /needs an image: ".*" is procedural/,
  /is the colours of ".*" too/,
  /is taken by an object before/,
  /needs to differ from "eye"/,
  /corner_radius needs to be/,
  /arc needs angles that differ/,
  /needs t above the point's before it/,
  /all its points are the same/,
];
const used = new Set();

const schema = JSON.parse(execFileSync(program, ['schema'], {encoding: 'utf8'}));
const ajv = new Ajv({strict: true, strictRequired: false, strictTypes: false, allErrors: false});
if (!ajv.validateSchema(schema)) throw new Error('the schema is none: ' + ajv.errorsText());
const isValid = ajv.compile(schema);

let faults = 0;
const complain = (text) => {
  ++faults;
  console.error(text);
};

const scenes = [...scenesIn(sampleScenes), ...scenesIn(awkwardScenes)];
for (const scene of scenes) {
  const value = JSON.parse(uncommented(readFileSync(scene, 'utf8')));
  if (!isValid(value)) complain(`${scene}: ${ajv.errorsText(isValid.errors)}`);
  if (!isValid({$schema: 'scene.schema.json', ...value})) complain(`${scene}: $schema is refused`);
}

execFileSync(faultsTest, ['--gtest_filter=SceneFaults.*'], {env: {...process.env, SWEEPKIT_KEEP_FAULTS: out}, stdio: 'ignore'});
let refused = 0;
let unseen = 0;
for (const name of readdirSync(out).filter((name) => name.endsWith('.json'))) {
  const message = readFileSync(join(out, name.replace('.json', '.txt')), 'utf8');
  let value;
  try {
    value = JSON.parse(uncommented(readFileSync(join(out, name), 'utf8')));
  } catch {
    continue;  // no JSON, which needs no schema
  }
  const isSeen = !isValid(value);
  const listed = kUnseen.filter((pattern) => pattern.test(message));
  const isListed = listed.length > 0;
  listed.forEach((pattern) => used.add(pattern));
  if (!isSeen && !isListed) complain(`passes the schema: ${message}`);
  if (isSeen && isListed) complain(`is listed as what a schema cannot see, and is refused: ${message}`);
  isSeen ? ++refused : ++unseen;
}
for (const pattern of kUnseen) {
  if (!used.has(pattern)) complain(`no refused scene tells of ${pattern}`);
}
if (refused < 100) complain(`only ${refused} scenes were there to be refused`);
console.log(`${scenes.length} scenes valid; of the refused ones ${refused} refused by the schema too, ${unseen} not to be seen by it`);
process.exit(faults > 0 ? 1 : 0);
