// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// What `sweepkit generate` can be asked for that makes another glTF file, in one place: each line is a name for the
// files and the options. A new option is a new line here; until it is one, the validator's test says so.
import {execFileSync} from 'node:child_process';
import {sweepkit} from './sweepkit.mjs';

export const variants = [
  {name: 'plain', options: []},
  {name: 'tangents', options: ['--tangents']},
  {name: 'unlit', options: ['--unlit']},
  {name: 'compatible', options: ['--compatible']},
  {name: 'separate', options: ['--images', 'separate']},
  {name: 'embedded', options: ['--images', 'embedded']},
  {name: 'png', options: ['--image-format', 'png']},
  {name: 'jpg', options: ['--image-format', 'jpg']},
  {name: 'small', options: ['--max-texture', '16']},
  {name: 'baked', options: ['--bake-size', '33']},
  {name: 'dense', options: ['--texel-density', '20']},
  {name: 'bare', options: ['--no-extras', '--copyright', '2026 Käthe "K" Töpfer']},
  {name: 'levels', options: ['--lod', '3'], hasLevels: true},
  // Blender shows a moment of what moves, and what assimp sums up is no moment's.
  {name: 'turning', options: ['--turntable', '8'], isMoving: true},
  // compressed.mjs loads these: their vertices are others, and not every program knows the extensions.
  {name: 'quantized', options: ['--quantize', '--position-bits', '14'], isCompressed: true},
  {name: 'packed', options: ['--meshopt'], isCompressed: true},
  {name: 'smallest', options: ['--quantize', '--meshopt', '--minimal'], isCompressed: true},
  {name: 'together', options: ['--unlit', '--tangents', '--images', 'separate', '--image-format', 'jpg', '--max-texture', '64']},
];

/** Baked textures have so many texels a side, unless a variant says otherwise: enough to be looked at, and soon made. */
export const bakeSize = 64;

export function generateVariant(program, scene, file, {options}) {
  const hasSize = options.some((option) => ['--bake-size', '--texel-density'].includes(option));
  const size = hasSize ? [] : ['--bake-size', bakeSize];
  sweepkit(program, 'generate', scene, '-o', file, '--quiet', ...size, ...options);
}

/** Options that ask for another scene, or for what is said, and not for another kind of file. */
const besides = [
  '--help', '--set', '--files-in', '--each', '--threads', '--explain', '--json', '--quiet',
  // One object alone: a scene of its own, which scenes of one object are too.
  '--object',
  // Refused where nothing is swept; motion.mjs has it.
  '--grow',
  // A scene without a file.
  '--contour', '--trajectory', '--profile', '--twist', '--guide', '--sweep-frames', '--caps', '--joints', '--texture',
  '--texture-size', '--tolerance', '--cells',
];

/** The options of `generate`, by its own help, that are in neither list, and those here that it does not have. */
export function strangers(program) {
  const help = execFileSync(program, ['generate', '--help'], {encoding: 'utf8'});
  const known = new Set([...help.matchAll(/^ +(?:-\w,)?(--[\w-]+)/gm)].map((match) => match[1]));
  const named = new Set([...besides, ...variants.flatMap(({options}) => options.filter((text) => text.startsWith('--')))]);
  return {unlisted: [...known].filter((option) => !named.has(option)), unknown: [...named].filter((option) => !known.has(option))};
}
