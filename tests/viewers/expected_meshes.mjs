// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// What a glTF file of a scene has to hold, told by what does not pass through the glTF writer: the scene's own text,
// `sweepkit info` of it, and the positions in the world, in double, of the .ply that `generate` makes of it.
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {sweepkit, uncommented} from './sweepkit.mjs';

// The corners of the boxes about runs of vertices and the triangles between them, run by run.
function readPly(file, vertexCounts, triangleCounts) {
  const bytes = readFileSync(file);
  const end = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  const header = bytes.toString('latin1', 0, end);
  const kSizes = {double: 8, float: 4};
  const [vertices, faces] = header.split('element face ');
  // Floats where they hold the positions as exactly as the file of floats about an origin does.
  const type = vertices.match(/property (double|float) x\nproperty \1 y\nproperty \1 z\n/)?.[1];
  if (!type || !/property list uchar int/.test(faces)) throw new Error(`${file}: unexpected header`);
  const stride = [...vertices.matchAll(/property (double|float) /g)].reduce((sum, [, type]) => sum + kSizes[type], 0);
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  let at = end;
  const boxes = vertexCounts.map((count) => {
    const min = [Infinity, Infinity, Infinity];
    const max = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < count; ++i, at += stride) {
      for (let k = 0; k < 3; ++k) {
        const value = type === 'double' ? data.getFloat64(at + 8 * k, true) : data.getFloat32(at + 4 * k, true);
        min[k] = Math.min(min[k], value);
        max[k] = Math.max(max[k], value);
      }
    }
    return {min, max};
  });
  const kFace = 1 + 3 * 4;
  if (at + kFace * triangleCounts.reduce((sum, count) => sum + count, 0) !== bytes.length) {
    throw new Error(`${file} has other counts than info tells`);
  }
  return boxes;
}

/**
 * Each instance of each object in the scene's order: {name, triangles, min, max, material, texture}. The material is
 * what the scene says of it; the texture is its size, or null.
 */
export function expectedMeshes(program, sceneFile, folder, bakeSize) {
  const info = JSON.parse(execFileSync(program, ['info', sceneFile, '--json'], {encoding: 'utf8'}));
  const scene = JSON.parse(uncommented(readFileSync(sceneFile, 'utf8')));
  const ply = join(folder, 'expected.ply');
  sweepkit(program, 'generate', sceneFile, '-o', ply, '--quiet');
  const instances = info.objects.flatMap((object) => Array(object.instances).fill(object));
  const boxes = readPly(ply, instances.map(({vertices}) => vertices), instances.map(({triangles}) => triangles));
  const materials = new Map(info.materials.map((material) => [material.material, material]));
  const textures = new Map(info.textures.map((texture) => [texture.texture, texture]));
  return instances.map((object, i) => {
    const texture = textures.get(materials.get(object.material)?.texture);
    return {
      name: object.object, triangles: object.triangles, ...boxes[i],
      material: {name: object.material ?? 'default', ...(scene.materials?.[object.material] ?? {})},
      texture: texture ? (texture.kind === 'image' ? [texture.width, texture.height] : [bakeSize, bakeSize]) : null,
    };
  });
}
