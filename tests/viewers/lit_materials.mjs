// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// What becomes of Whitted's mirrors and highlights in three.js, or with the word "blender" in Blender's Cycles, measured in linear numbers and printed as the tables of
// docs/gltf.md:
//   - the share of a white environment that a floor mirrors, by the angle at which it is seen;
//   - how high the highlight is that a light behind the eye makes on a ball, and how wide where it is half as high as the
//     scene's is in the middle.
// The ray tracer has to show the closed forms of its own terms, the other program those of the microfacets that the conversion is
// derived for; so each difference between the two pictures is the two laws' own. Materials: some made up for the terms,
// and what mirrors or shines in the samples.
import {execFileSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {basename, dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import pngjs from 'pngjs';
import {withThree} from './browser.mjs';
import {blinnHalfWidth, f0Of, fresnelExact, glint, mirroredShare, schlick} from './lobes.mjs';
import {freshFolder, sampleScenes, scenesIn, sweepkit, uncommented} from './sweepkit.mjs';

const [program, out, ...words] = process.argv.slice(2);
const isCycles = words.includes('blender');
const theirName = isCycles ? 'Cycles' : 'three.js';
freshFolder(out);

// PNG of 16 bits: half a step of sRGB is at most 2.4 / 1.055 x 2^-17 of a linear number; reflect is float32.
const kOurExactness = 3e-5;
// three.js has the shares in a table of 32 x 32 half floats (2^-11 of a share) over roughness and N.V, between which it
// goes straight: what that is off by was measured, at most 0.012, where the mirror's edge rises steeply (85 degrees).
const kTheirExactness = 0.015;
// The places between pixels are on chords of a curve: of 340 pixels to a half width (1 / 340)^2; sRGB's steps are finer.
const kOurWidth = 1e-3;
// Of three.js's highlights against GGX, but for second bounces: its floats of 24 bits, and derivatives of normals by
// pairs of pixels. What those add to the roughness, 4 times as much in the height, makes heights 1 % lower than the
// scene's; the sharpest lobe here, of 0.15, has less than 2.5 %.
const kHighlightExactness = 0.01;
const kLeastHeight = 0.015;
// And its power of Schlick's by exp2, which is not 0 where the fifth power is, but this much of what F0 lacks to 1.
const kSchlicksRest = 2 ** -12.5;
// Cycles has Fresnel's own law instead of Schlick's: only at right angles are both F0. Its paths are random; before white
// they all end at 1, but some in the floor's other side.
const kCyclesShare = 0.005;
// three.js takes no mirror for sharper, whose environment has no sharper picture.
const kLeastRoughness = 0.0525;

let faults = 0;
function demand(isRight, text) {
  if (isRight) return;
  ++faults;
  console.error(text);
}
const radians = (degrees) => degrees * Math.PI / 180;
const degrees = (radians) => radians * 180 / Math.PI;
const linear = (x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
const isClose = (a, b, within) => Math.abs(a - b) <= within;

function materialsOfSamples() {
  const found = new Map();
  for (const file of scenesIn(sampleScenes)) {
    const {materials = {}} = JSON.parse(uncommented(readFileSync(file, 'utf8')));
    for (const [name, {texture, normal_map, normal_strength, ...material}] of Object.entries(materials)) {
      found.set(JSON.stringify(material), [`${basename(file, '.json')}: ${name}`, material]);
    }
  }
  return [...found.values()];
}

function drawInCycles(job) {
  const files = [join(out, 'job.json'), join(out, 'cycles.json')];
  writeFileSync(files[0], JSON.stringify(job));
  const script = join(dirname(fileURLToPath(import.meta.url)), 'draw_in_cycles.py');
  execFileSync('blender', ['-b', '--factory-startup', '--python-exit-code', '1', '--python', script, '--', ...files],
               {stdio: ['ignore', 'ignore', 'pipe'], maxBuffer: 1e9});
  return JSON.parse(readFileSync(files[1], 'utf8'));
}

/** Linear [r, g, b] of each pixel, ours and the other program's, and the terms that are in the file. */
async function draw(page, urlOf, scene, isBeforeWhite) {
  const sceneFile = join(out, 'scene.json');
  const glb = join(out, 'scene.glb');
  const picture = join(out, 'ours.png');
  writeFileSync(sceneFile, JSON.stringify(scene));
  sweepkit(program, 'generate', sceneFile, '-o', glb, '--quiet');
  sweepkit(program, 'render', sceneFile, '-o', picture, '--bits', '16', '--quiet');
  const {data} = pngjs.PNG.sync.read(readFileSync(picture), {skipRescale: true});
  const ours = Array.from({length: data.length / 4}, (_, i) => [0, 1, 2].map((k) => linear(data[4 * i + k] / 65535)));
  const {width, height} = scene.camera;
  const theirs = isCycles ? drawInCycles({file: glb, width, height, isBeforeWhite}) :
    await page.evaluate((given) => window.measure(given), {url: urlOf('scene.glb'), width, height, isBeforeWhite});
  const bytes = readFileSync(glb);
  const entry = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12))).materials.find(({name}) => name === 'it');
  const {roughnessFactor = 1, metallicFactor = 1, baseColorFactor = [1]} = entry.pbrMetallicRoughness;
  return {ours, theirs, roughness: roughnessFactor, metal: metallicFactor === 1 ? baseColorFactor[0] : null};
}

// The picture's columns go from straight down to the horizon.
const kSeen = {width: 9, height: 257};
const kAxis = 44;
const incidence = (row) => radians(kAxis) + Math.atan((1 - 2 * (row + 0.5) / kSeen.height) * Math.tan(radians(kAxis)));

function mirrorScene(material) {
  const target = [Math.sin(radians(kAxis)), 1 - Math.cos(radians(kAxis)), 0];
  const {specular, ...mirror} = material;
  return {
    sweepkit: 1, background: [1, 1, 1], ambient: [0, 0, 0], lights: [],
    camera: {eye: [0, 1, 0], target, fov_deg: 2 * kAxis, ...kSeen},
    materials: {it: material, black: {diffuse: [0, 0, 0]}},
    objects: [
      {name: 'floor', material: 'it', plane: {size: [400, 400]}},
      {name: 'under what is clear', material: 'black', translate: [0, -1, 0], plane: {size: [4000, 4000]}},
    ],
  };
}

// Whitted's share, and F0 and F90 of what stands for it.
function mirrorLaws({specular = [0], shininess = 50, reflect = 0, ior = 1, fresnel = 'none', transmit = 0}, metal) {
  const f0 = f0Of(ior);
  if (fresnel !== 'none') {
    const ours = (angle) => reflect * (fresnel === 'exact' ? fresnelExact(angle, ior) : schlick({f0, f90: 1}, Math.cos(angle)));
    return {ours, glTF: {f0: reflect * f0, f90: reflect}};
  }
  const coat = reflect > 0 ? reflect : Math.min(1, 8 * specular[0] / (shininess + 2));
  const isClear = transmit > 0 && reflect === 0;
  const glTF = isClear ? {f0: 0, f90: 0} : {f0: (metal ?? coat) || 0.04, f90: 1};
  return {ours: () => reflect, glTF};
}

async function measureMirrors(page, urlOf, materials) {
  const kAngles = [0, 45, 60, 75, 85];
  const rows = kAngles.map((angle) => Array.from({length: kSeen.height}, (_, row) => row)
    .reduce((a, b) => (Math.abs(incidence(b) - radians(angle)) < Math.abs(incidence(a) - radians(angle)) ? b : a)));
  console.log(`| material | roughness | ${kAngles.map((angle) => `${angle} deg`).join(' | ')} |`);
  for (const [name, material] of materials) {
    const {ours, theirs, roughness, metal} = await draw(page, urlOf, mirrorScene(material), true);
    const laws = mirrorLaws(material, metal);
    const cells = rows.map((row) => {
      const angle = incidence(row);
      const at = row * kSeen.width + (kSeen.width >> 1);
      const [our, their] = [ours[at][0], theirs[at][0]];
      const {share, all} = mirroredShare(angle, Math.max(roughness, kLeastRoughness), laws.glTF);
      const where = `${name}, seen at ${degrees(angle).toFixed(1)} degrees`;
      demand(isClose(our, laws.ours(angle), kOurExactness), `${where}: ${our} by the ray tracer, not ${laws.ours(angle)}`);
      if (isCycles) {
        demand(row !== rows[0] || isClose(their, laws.glTF.f0, kCyclesShare), `${where}: ${their} in Cycles, not ${laws.glTF.f0}`);
      } else {
        // What meets a second microfacet may come back or not.
        demand(their >= share - kTheirExactness && their <= share + (1 - all) * laws.glTF.f90 + kTheirExactness,
               `${where}: ${their} in three.js, not ${share} and some of ${1 - all}`);
      }
      return `${our.toFixed(3)} ${their.toFixed(3)}`;
    });
    console.log(`| ${name} | ${roughness.toFixed(2)} | ${cells.join(' | ')} |`);
  }
}

// One line of the picture goes across the ball, a little further than three half widths of its highlight.
const kAcross = 1025;
const kLines = 9;
const kFar = 40;
const spanOf = ({shininess = 50}) => Math.sin(Math.min(3 * blinnHalfWidth(shininess), radians(80))) / kFar;

// Nothing is over 1.
const dimmedFor = ({diffuse = [0.8, 0.8, 0.8], specular}) => 1 / Math.max(1, ...specular.map((value, k) => value + diffuse[k]));

function highlightScene(material) {
  const light = dimmedFor(material);
  const fov = 2 * degrees(Math.atan(spanOf(material) * kLines / kAcross));
  const ball = {tessellation: {contour: 128, trajectory: 256}, revolve: {contour: {arc: {radius: 1, from_deg: -90, to_deg: 90}}}};
  return {
    sweepkit: 1, background: [0, 0, 0], ambient: [0, 0, 0], lights: [{directional: [0, 0, -1], intensity: [light, light, light]}],
    camera: {eye: [0, 0, kFar], target: [0, 0, 0], fov_deg: fov, width: kAcross, height: kLines},
    materials: {it: material},
    objects: [{name: 'ball', material: 'it', ...ball}],
  };
}

// Angles and cosines where the pixel's ray meets the ball of radius 1, in the plane y = 0; vectors are (x, z).
function onBall(x, span) {
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1];
  const ray = [(2 * (x + 0.5) / kAcross - 1) * span, -1];
  const length2 = dot(ray, ray);
  const t = (kFar - Math.sqrt(kFar ** 2 - length2 * (kFar ** 2 - 1))) / length2;
  const normal = [t * ray[0], kFar - t];
  const view = ray.map((value) => -value / Math.sqrt(length2));
  const half = [view[0], view[1] + 1].map((value, _, both) => value / Math.hypot(...both));
  const nh = Math.min(1, dot(normal, half));
  return {normal, angle: Math.acos(nh), nh, nl: normal[1], nv: dot(normal, view), vh: dot(view, half)};
}

// Height, and width where it is `half` as high, on one side times two, in degrees between normal and half vector.
function shapeOf(places, values, half) {
  const height = Math.max(...values);
  let i = values.indexOf(height);
  while (i + 1 < values.length && values[i + 1] > half) ++i;
  const past = (values[i] - half) / (values[i] - values[i + 1]);
  return {height, width: 2 * degrees(places[i].angle + past * (places[i + 1]?.angle - places[i].angle))};
}

async function measureHighlights(page, urlOf, materials) {
  console.log(`| material | n | roughness | width of ours | in ${theirName} | ratio | height of ours | in ${theirName} |`);
  for (const [name, material] of materials) {
    const {ours, theirs, roughness} = await draw(page, urlOf, highlightScene(material), false);
    const {diffuse = [0.8, 0.8, 0.8], specular, shininess = 50, reflect = 0} = material;
    const light = dimmedFor(material);
    const places = Array.from({length: kAcross}, (_, x) => onBall(x, spanOf(material)));
    // Of one colour and without what is scattered.
    const across = (pixels, k) => places.map(({nl}, x) => pixels[(kLines >> 1) * kAcross + x][k] / light - diffuse[k] * nl);
    const our = shapeOf(places, across(ours, 0), specular[0] / 2);
    const their = shapeOf(places, across(theirs, 0), specular[0] / 2);
    console.log(`| ${name} | ${shininess} | ${roughness.toFixed(3)} | ${our.width.toFixed(2)} | ${their.width.toFixed(2)} | ` +
                `${(their.width / our.width).toFixed(3)} | ${our.height.toFixed(3)} | ${their.height.toFixed(3)} |`);
    demand(isClose(our.height, specular[0], kOurExactness / light) && isClose(our.width / (2 * degrees(blinnHalfWidth(shininess))), 1, kOurWidth),
           `${name}: by the ray tracer ${our.height} high, ${our.width} wide`);

    // three.js adds to the roughness how much a normal turns from pixel to pixel.
    const turned = (x) => isCycles ? 0 : Math.abs(places[Math.min(x + 1, kAcross - 1)].normal[0] - places[Math.max(x - 1, 0)].normal[0]) / 2;
    [0, 1, 2].forEach((k) => {
      const f = reflect > 0 ? reflect : Math.min(1, 8 * specular[k] / (shininess + 2));
      const law = shapeOf(places, places.map((place, x) => glint(place, Math.max(roughness, kLeastRoughness) + turned(x), {f0: f, f90: 1})),
                          specular[k] / 2);
      const found = shapeOf(places, across(theirs, k), specular[k] / 2);
      // Light that meets two microfacets, mirrored by each: at most f f of what misses the eye by one on both ways.
      const twice = Math.PI * f ** 2 * (1 - mirroredShare(0, roughness, {f0: 1, f90: 1}).all) ** 2 / law.height;
      const more = twice + kSchlicksRest / f;
      for (const what of ['height', 'width']) {
        demand(isClose(found[what] / law[what], 1, kHighlightExactness + more), `${name}: in ${theirName} ${what} ${found[what]}, not ${law[what]}`);
      }
      if (reflect > 0) return;
      demand(isClose(found.height / specular[k], 1, kLeastHeight + more), `${name}: in ${theirName} ${found.height} high, not ${specular[k]}`);
    });
  }
}

const samples = materialsOfSamples();
const grey = {diffuse: [0.5, 0.5, 0.5]};
const mirrors = [
  ...[0, 0.1, 0.3, 0.6, 0.9, 1].map((reflect) => [`d 0.5, r ${reflect}`, {...grey, reflect}]),
  ['d 1, r 0.9', {diffuse: [1, 1, 1], reflect: 0.9}],
  ['r 1, exact, ior 1.5', {...grey, reflect: 1, ior: 1.5, fresnel: 'exact'}],
  ['r 1, schlick, ior 1.5', {...grey, reflect: 1, ior: 1.5, fresnel: 'schlick'}],
  ['r 0.5, exact, ior 2', {...grey, reflect: 0.5, ior: 2, fresnel: 'exact'}],
  ...samples.filter(([, {reflect = 0}]) => reflect > 0),
];
const shiny = (shininess) => ['specular 0.8', {diffuse: [0, 0, 0], specular: [0.8, 0.8, 0.8], shininess}];
const shining = samples.filter(([, {specular = [0], transmit = 0}]) => specular[0] > 0 && transmit === 0);
const named = (materials, ...names) => materials.filter(([name]) => names.includes(name));

if (isCycles) {
  await measureMirrors(null, null, named(mirrors, 'd 0.5, r 0.1', 'd 0.5, r 0.3', 'd 0.5, r 0.9', 'r 1, exact, ior 1.5', 'vase_and_cup: porcelain'));
  await measureHighlights(null, null, [...[20, 80, 300].map(shiny), ...named(shining, 'column: marble', 'spring: steel')]);
} else {
  await withThree(out, async (page, urlOf) => {
    await measureMirrors(page, urlOf, mirrors);
    await measureHighlights(page, urlOf, [...[5, 20, 80, 300, 600].map(shiny), ...shining]);
  }, 'material_page.js');
}
process.exit(faults > 0 ? 1 : 0);
