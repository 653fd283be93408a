// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, readdirSync, rmSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));

/** The scenes in the samples, and those of this folder that are there to be awkward. */
export const sampleScenes = join(here, '../../samples/scenes');
export const awkwardScenes = join(here, 'scenes');

export function scenesIn(folder) {
  return readdirSync(folder).filter((name) => name.endsWith('.json')).sort().map((name) => join(folder, name));
}

// JSON without its comments of both kinds.
export function uncommented(text) {
  return text.replace(/("(?:\\.|[^"\\])*")|\/\/[^\n]*|\/\*[\s\S]*?\*\//g, (_, string) => string ?? ' ');
}

export function freshFolder(folder) {
  rmSync(folder, {recursive: true, force: true});
  mkdirSync(folder, {recursive: true});
  return folder;
}

/** Runs the program; throws, with what it said, unless it ends with 0. */
export function sweepkit(program, ...args) {
  execFileSync(program, args, {stdio: ['ignore', 'ignore', 'inherit']});
}
