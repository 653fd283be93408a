// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// What --quantize, --meshopt and --minimal write has no error and no warning in the Khronos validator and loads in
// three.js, by its own decoders: as many triangles as without, and each vertex within the promised half a step of one
// of the plain file's. The validator does not look into what EXT_meshopt_compression packs (it says so); three.js does.
import validator from 'gltf-validator';
import {readFileSync} from 'node:fs';
import {basename, join} from 'node:path';
import {Box3, Vector3} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
import {MeshoptDecoder} from 'three/addons/libs/meshopt_decoder.module.js';
import {freshFolder, sampleScenes, sweepkit} from './sweepkit.mjs';

const [program, out] = process.argv.slice(2);
freshFolder(out);
globalThis.self = globalThis;  // the loader was written for browsers

// Without textures, which would need a browser.
const kScenes = ['spring', 'star_to_circle', 'trefoil_knot', 'curves'];
const kVariants = [
  ['quantized', 16, '--quantize'],
  ['packed', 24, '--meshopt'],
  ['both', 12, '--quantize', '--meshopt', '--position-bits', '12'],
  ['smallest', 14, '--quantize', '--meshopt', '--minimal', '--position-bits', '14'],
];

async function load(file) {
  const bytes = readFileSync(file);
  const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder);
  const model = await loader.parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
  model.scene.updateMatrixWorld(true);
  const meshes = [];
  model.scene.traverse((node) => {
    if (node.isMesh) meshes.push(node);
  });
  return meshes.map((mesh) => {
    const {position, normal} = mesh.geometry.attributes;
    const places = Array.from({length: position.count}, (_, i) =>
      new Vector3().fromBufferAttribute(position, i).applyMatrix4(mesh.matrixWorld));
    return {places, triangles: mesh.geometry.index.count / 3, normals: normal.count};
  });
}

// The largest distance from one of `places` to the nearest of `others`, along one axis; cells as wide as the reach.
function farthest(places, others, reach) {
  const key = (x, y, z) => `${x},${y},${z}`;
  const cells = new Map();
  for (const place of others) {
    const at = key(...place.toArray().map((x) => Math.floor(x / reach)));
    cells.set(at, [...(cells.get(at) ?? []), place]);
  }
  let worst = 0;
  for (const place of places) {
    const [x, y, z] = place.toArray().map((value) => Math.floor(value / reach));
    let nearest = Infinity;
    for (let i = x - 1; i <= x + 1; ++i) {
      for (let j = y - 1; j <= y + 1; ++j) {
        for (let k = z - 1; k <= z + 1; ++k) {
          for (const other of cells.get(key(i, j, k)) ?? []) {
            nearest = Math.min(nearest, Math.max(...place.clone().sub(other).toArray().map(Math.abs)));
          }
        }
      }
    }
    worst = Math.max(worst, nearest);
  }
  return worst;
}

let faults = 0;
const complain = (text) => {
  ++faults;
  console.error(text);
};
let files = 0;
for (const scene of kScenes) {
  const make = (name, ...more) => {
    const file = join(out, `${scene}_${name}.glb`);
    sweepkit(program, 'generate', join(sampleScenes, scene + '.json'), '-o', file, '--quiet', ...more);
    return file;
  };
  const plain = await load(make('plain'));
  for (const [name, bits, ...more] of kVariants) {
    const file = basename(make(name, ...more));
    const {issues} = await validator.validateBytes(new Uint8Array(readFileSync(join(out, file))), {maxIssues: 0});
    if (issues.numErrors + issues.numWarnings > 0) complain(`${file}: ${JSON.stringify(issues.messages)}`);
    const packed = await load(join(out, file));
    ++files;
    if (packed.length !== plain.length) complain(`${file}: ${packed.length} meshes in place of ${plain.length}`);
    packed.forEach((mesh, index) => {
      const {places, triangles} = plain[index];
      if (mesh.triangles !== triangles) complain(`${file}: ${mesh.triangles} triangles in place of ${triangles}`);
      if (mesh.normals !== mesh.places.length) complain(`${file}: ${mesh.normals} normals`);
      const size = new Box3().setFromPoints(places).getSize(new Vector3());
      const side = Math.max(size.x, size.y, size.z);
      // Half a step, and what the viewer's own floats round: a few units of 2^-24 of coordinates.
      const bound = side / (2 ** bits - 1) / 2 + 4 * 2 ** -24 * (side + Math.max(...places[0].toArray().map(Math.abs)));
      for (const [from, to] of [[mesh.places, places], [places, mesh.places]]) {
        const off = farthest(from, to, 4 * bound);
        if (!(off <= bound)) complain(`${file}: mesh ${index} is off by ${off}, over ${bound}`);
      }
    });
  }
}
console.log(`${files} files, ${faults} faults`);
process.exit(faults > 0 ? 1 : 0);
