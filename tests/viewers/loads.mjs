// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// What `generate` writes loads in three.js and assimp, or with the word "blender" in Blender, with the triangles, the
// bounds, the materials and the textures that the scene has (expected_meshes.mjs): every sample scene as a .glb, and
// some scenes in both containers with every option that options.mjs lists; with the word "all" every scene so.
import {execFileSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {basename, dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {withThree} from './browser.mjs';
import {expectedMeshes} from './expected_meshes.mjs';
import {bakeSize, generateVariant, variants} from './options.mjs';
import {awkwardScenes, freshFolder, sampleScenes, scenesIn} from './sweepkit.mjs';

const [program, out, ...words] = process.argv.slice(2);
freshFolder(out);
const isAll = words.includes('all');
const kSome = ['vase_and_cup', 'semi_transparent', 'awkward'];
let faults = 0;
const complain = (text) => {
  ++faults;
  console.error(text);
};

function generateFiles() {
  const files = [];
  for (const scene of [...scenesIn(sampleScenes), ...scenesIn(awkwardScenes)]) {
    const name = basename(scene, '.json');
    const isWhole = isAll || kSome.includes(name);
    const expected = expectedMeshes(program, scene, out, bakeSize);
    for (const variant of isWhole ? variants.filter(({isCompressed}) => !isCompressed) : variants.slice(0, 1)) {
      for (const container of isWhole ? ['glb', 'gltf'] : ['glb']) {
        const file = join(out, `${name}_${variant.name}.${container}`);
        generateVariant(program, scene, file, variant);
        files.push({file, expected, variant});
      }
    }
  }
  return files;
}

// The sizes of a texture after --max-texture, and of a baked one after --bake-size.
function sizeAfter([width, height], {options}) {
  const value = (option, otherwise) => (options.includes(option) ? Number(options[options.indexOf(option) + 1]) : otherwise);
  const most = value('--max-texture', Infinity);
  const larger = Math.max(width, height);
  return larger > most ? {larger: most} : {larger};
}

const near = (a, b, within) => a.every((value, k) => Math.abs(value - b[k]) <= within);

// Stored positions are float32 relative to their mesh: half a unit in the last place of the mesh's extent. A program
// that multiplies by matrices of float32, as Blender, is out by some units in the last place of the coordinate.
function boundsWithin(expected, isFloat) {
  const extent = Math.hypot(...expected.max.map((value, k) => value - expected.min[k]));
  const farthest = Math.max(...[...expected.min, ...expected.max].map(Math.abs));
  return 2 ** -22 * extent + (isFloat ? 2 ** -21 * farthest : 2 ** -50 * farthest);
}

function isTheMesh(found, expected, variant, isFloat) {
  if (found.triangles !== expected.triangles) return false;
  const within = boundsWithin(expected, isFloat);
  if (!near(found.min, expected.min, within) || !near(found.max, expected.max, within)) return false;
  if (found.material.name !== expected.material.name) return false;
  if ((found.texture === null) !== (expected.texture === null)) return false;
  if (!expected.texture || variant.options.some((option) => ['--bake-size', '--texel-density'].includes(option))) return true;
  return Math.max(...found.texture) === sizeAfter(expected.texture, variant).larger;
}

// What the scene says of the material, as docs/gltf.md tells it, where that is one term for one.
function materialFault({material}, expected, variant) {
  const {diffuse = [0.8, 0.8, 0.8], specular = [0, 0, 0], shininess = 50, reflect = 0, transmit = 0, fresnel = 'none'} = expected.material;
  const isUnlit = variant.options.includes('--unlit');
  if (isUnlit !== (material.type === 'MeshBasicMaterial')) return `is a ${material.type}`;
  const isGlass = transmit > 0;
  const hasExtensions = !isUnlit && !variant.options.includes('--compatible');
  if (hasExtensions && (material.transmission > 0) !== isGlass) return `transmits ${material.transmission}`;
  if (isGlass) return '';
  const isMetal = fresnel === 'none' && reflect > Math.max(...diffuse);
  if (!isUnlit && material.metalness !== (isMetal ? 1 : 0)) return `has metalness ${material.metalness}`;
  if (!near(material.color, isMetal ? [reflect, reflect, reflect] : diffuse, 1e-6)) return `has the colour ${material.color}`;
  if (isUnlit || reflect > 0) return '';
  const roughness = specular.some((value) => value > 0) ? (2 / (shininess + 2)) ** 0.25 : 1;
  return Math.abs(material.roughness - roughness) <= 1e-6 ? '' : `has roughness ${material.roughness}`;
}

async function loadInThree(files) {
  await withThree(out, async (page, urlOf) => {
    for (const {file, expected, variant} of files) {
      const meshes = await page.evaluate((url) => window.describe(url), urlOf(basename(file)));
      if (meshes.length !== expected.length) complain(`${file}: three.js finds ${meshes.length} meshes, not ${expected.length}`);
      meshes.slice(0, expected.length).forEach((found, i) => {
        if (!isTheMesh(found, expected[i], variant, false)) {
          complain(`${file}: three.js finds ${JSON.stringify(found)}, not ${JSON.stringify(expected[i])}`);
        }
        const fault = materialFault(found, expected[i], variant);
        if (fault) complain(`${file}: in three.js the material of "${expected[i].name}" ${fault}`);
      });
    }
  });
  console.log(`three.js: ${files.length} files`);
}

// `assimp info` sums up: meshes with their triangles, materials, embedded textures, the bounds of all (in float32).
function loadInAssimp(files) {
  for (const {file, expected, variant} of files) {
    const text = execFileSync('assimp', ['info', file], {encoding: 'utf8'});
    const vector = (name) => text.match(new RegExp(`^${name} +\\(([^)]*)\\)`, 'm'))[1].split(' ').map(Number);
    const inOrder = (numbers) => [...numbers].sort((a, b) => a - b).join(' ');
    // An object's instances share its mesh.
    const objects = [...new Map(expected.map((mesh) => [mesh.name, mesh])).values()];
    const triangles = [...text.matchAll(/^ +\d+ \(.*\): \[\d+ \/ \d+ \/ (\d+) \| triangle\]$/gm)].map((match) => Number(match[1]));
    if (inOrder(triangles) !== inOrder(objects.map((mesh) => mesh.triangles))) {
      complain(`${file}: assimp finds meshes of ${triangles} triangles`);
    }
    const materials = [...text.matchAll(/^ +'(.*)' \(prop\)/gm)].map((match) => match[1]);
    const used = new Set(expected.map((mesh) => mesh.material.name));
    if ([...used].some((name) => !materials.includes(name)) || materials.some((name) => !used.has(name))) {
      complain(`${file}: assimp finds the materials ${materials}`);
    }
    const all = {
      min: [0, 1, 2].map((k) => Math.min(...expected.map((mesh) => mesh.min[k]))),
      max: [0, 1, 2].map((k) => Math.max(...expected.map((mesh) => mesh.max[k]))),
    };
    const within = boundsWithin(all, true) + 1e-6;  // printed to six decimals
    const isAsBounded = near(vector('Minimum point'), all.min, within) && near(vector('Maximum point'), all.max, within);
    if (!variant.isMoving && !isAsBounded) {
      complain(`${file}: assimp finds bounds of ${vector('Minimum point')} to ${vector('Maximum point')}, not ${all.min} to ${all.max}`);
    }
    const images = JSON.parse(execFileSync(program, ['info', file, '--json'], {encoding: 'utf8'})).images;
    const embedded = Number(text.match(/^Textures \(embed\.\): +(\d+)$/m)[1]);
    const beside = new Set([...text.matchAll(/^ {4}'([^*].*)'$/gm)].map((match) => match[1]));
    if (embedded + beside.size !== images.length) {
      complain(`${file}: assimp finds ${embedded} textures inside and ${beside.size} beside, not ${images.length}`);
    }
  }
  console.log(`assimp: ${files.length} files`);
}

// Blender keeps no order: each mesh that the scene has needs to be there, and no other.
function loadInBlender(files) {
  const listed = join(out, 'files.json');
  const result = join(out, 'blender.json');
  writeFileSync(listed, JSON.stringify(files.map(({file}) => file)));
  const script = join(dirname(fileURLToPath(import.meta.url)), 'load_in_blender.py');
  execFileSync('blender', ['-b', '--factory-startup', '--python-exit-code', '1', '--python', script, '--', listed, result],
               {stdio: ['ignore', 'ignore', 'pipe'], maxBuffer: 1e9});
  const loaded = JSON.parse(readFileSync(result, 'utf8'));
  for (const {file, expected, variant} of files) {
    const left = [...loaded[file]];
    for (const mesh of expected) {
      const at = left.findIndex((found) => isTheMesh(found, mesh, variant, true));
      if (at < 0) complain(`${file}: Blender has no ${JSON.stringify(mesh)} but ${JSON.stringify(loaded[file])}`);
      else left.splice(at, 1);
    }
    if (left.length > 0) complain(`${file}: Blender has ${left.length} meshes too many`);
  }
  console.log(`Blender: ${files.length} files`);
}

const files = generateFiles();
if (words.includes('blender')) {
  // Its importer takes every node, whether the scene has it or not: coarser meshes stand in the finest.
  loadInBlender(files.filter(({variant}) => !variant.isMoving && !variant.hasLevels));
} else {
  await loadInThree(files);
  loadInAssimp(files);
}
console.log(`${faults} faults`);
process.exit(faults > 0 ? 1 : 0);
