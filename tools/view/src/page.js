// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
import {Box3, Sphere} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
import {MeshoptDecoder} from 'three/addons/libs/meshopt_decoder.module.js';
import {kCurves, makeCurves} from './curves.js';
import {kLooks, Looks} from './looks.js';
import {Motion} from './motion.js';
import {Panel} from './panel.js';
import {Stage} from './stage.js';

const root = document.documentElement;
const message = document.getElementById('message');

function text(id) {
  return document.getElementById(id).textContent.trim();
}

function bytesOf(base64) {
  return Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer;
}

function count(number, what) {
  return `${number.toLocaleString('en')} ${what}${number === 1 ? '' : 's'}`;
}

// three.js changes spaces and the like in a node's own name.
function nameOf(node) {
  return node.userData.name ?? node.name;
}

function trianglesOf(node) {
  let sum = 0;
  node.traverse(({isMesh, geometry}) => {
    if (isMesh) sum += (geometry.index ?? geometry.attributes.position).count / 3;
  });
  return sum;
}

function applyTheme(stage) {
  stage.background(getComputedStyle(root).getPropertyValue('--ground').trim());
}

async function start() {
  if (!document.createElement('canvas').getContext('webgl2')) {
    throw new Error('This browser draws no WebGL here: it is switched off, or the graphics driver is missing.');
  }
  const facts = JSON.parse(text('facts'));
  const gltf = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).parseAsync(bytesOf(text('model')), '');
  const model = gltf.scene;
  const stage = new Stage(document.getElementById('stage'), model, gltf.cameras);
  const looks = new Looks(model, stage.renderer.capabilities.getMaxAnisotropy());
  const curves = makeCurves(facts.curves ?? {}, stage);
  const hasCurves = Object.keys(curves).length > 0;

  const motion = gltf.animations.length > 0 ? new Motion(model, gltf.animations, stage) : null;

  const chosen = {look: 'finished', wires: false, curves: false, theme: '', playing: false};
  const note = () => Object.entries(chosen).forEach(([name, value]) => root.setAttribute(`data-${name}`, value));
  // What turns as a whole stands on a node of its own.
  const objects = (model.getObjectByName('turntable') ?? model).children.filter((node) => trianglesOf(node) > 0);
  const showCurves = () => {
    for (const node of objects) if (curves[nameOf(node)]) curves[nameOf(node)].visible = chosen.curves && node.visible;
  };
  const change = (name, value) => {
    chosen[name] = value;
    looks.show(chosen.look);
    looks.showWires(chosen.wires);
    showCurves();
    note();
    applyTheme(stage);
  };
  const play = () => {
    motion.toggle();
    change('playing', motion.isPlaying);
  };
  change('look', 'finished');
  root.setAttribute('data-lights', String(stage.lights));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => applyTheme(stage));

  const sphereOf = (node) => new Box3().setFromObject(node).getBoundingSphere(new Sphere());
  const legend = Object.values(kCurves).map(([name]) => name.toLowerCase()).join(', ');
  const panel = new Panel({
    title: facts.title,
    summary: `${count(objects.length, 'object')}, ${count(trianglesOf(model), 'triangle')}`,
    looks: kLooks.map(([look, label, title], i) => ({
      id: `look-${look}`, label, title, key: String(i + 1), run: () => change('look', look), isPressed: () => chosen.look === look,
    })),
    toggles: [
      {id: 'wires', label: 'Wireframe', title: 'The triangles\' edges', key: 'W', run: () => change('wires', !chosen.wires),
       isPressed: () => chosen.wires},
      {id: 'curves', label: 'Curves', title: hasCurves ? `What it was made of: ${legend}` : 'This file does not say what it was made of',
       key: 'C', run: () => change('curves', !chosen.curves), isPressed: () => chosen.curves, isUsable: () => hasCurves},
      ...(motion ? [{id: 'play', label: 'Play', title: 'The file\'s animations, or a pause', key: 'P', run: play, isPressed: () => motion.isPlaying}] : []),
    ],
    views: [
      {id: 'reset', label: 'Camera', title: 'From where the file\'s camera stands', key: 'R', run: () => stage.reset()},
      {id: 'fit', label: 'Fit', title: 'Everything in view', key: 'F', run: () => stage.fit(stage.bounds)},
      {id: 'theme', label: 'Light / dark', title: 'Another background', key: 'T', run: () => {
        const isDark = getComputedStyle(root).colorScheme === 'dark';
        change('theme', isDark ? 'light' : 'dark');
      }},
    ],
    onCover: (right, bottom) => stage.cover(right, bottom),
    objects: objects.map((node) => ({
      name: nameOf(node),
      triangles: trianglesOf(node).toLocaleString('en'),
      show: (isShown) => {
        node.visible = isShown;
        showCurves();
        stage.draw();
      },
      frame: () => stage.fit(sphereOf(node)),
    })),
    keys: [['M', 'Show or hide the panel'], ['Arrows', 'Turn'], ['+ and -', 'Zoom'], ['?', 'These keys'],
           ['Drag', 'Turn; with the right button, or two fingers, move'], ['Wheel, pinch', 'Zoom']],
  });

  const moves = {
    ArrowLeft: () => stage.turn(-1, 0), ArrowRight: () => stage.turn(1, 0), ArrowUp: () => stage.turn(0, 1),
    ArrowDown: () => stage.turn(0, -1), '+': () => stage.zoom(1), '=': () => stage.zoom(1), '-': () => stage.zoom(-1),
  };
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches?.('input')) return;
    if (moves[event.key]) moves[event.key]();
    else if (!panel.press(event.key)) return;
    event.preventDefault();
  });
  if (motion && !matchMedia('(prefers-reduced-motion: reduce)').matches) panel.press('p');
  message.textContent = '';
  stage.renderer.render(stage.scene, stage.camera);
  requestAnimationFrame(() => requestAnimationFrame(() => root.setAttribute('data-state', 'ready')));
}

start().catch((error) => {
  root.setAttribute('data-state', 'failed');
  message.textContent = `The model cannot be shown. ${error.message ?? error}`;
  console.error(error);
});
