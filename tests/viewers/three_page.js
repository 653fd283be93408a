// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Runs in the browser: what three.js makes of a glTF file.
import {Box3, Color, MeshBasicMaterial, NoToneMapping, Scene, SRGBColorSpace, WebGLRenderer} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
import {MeshoptDecoder} from 'three/addons/libs/meshopt_decoder.module.js';

async function load(url) {
  const model = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).loadAsync(url);
  model.scene.updateMatrixWorld(true);
  return model;
}

let renderer;
function rendererOf(width, height) {
  renderer ??= new WebGLRenderer({antialias: false, alpha: true, preserveDrawingBuffer: true});
  renderer.setPixelRatio(1);
  renderer.setSize(width, height);
  renderer.toneMapping = NoToneMapping;
  renderer.outputColorSpace = SRGBColorSpace;
  return renderer;
}

// three.js turns the spaces of a node's name into underscores.
const nameOf = (node) => node.userData.name ?? (node.parent.userData.name || node.name);

// Draws a file with the camera that it holds. "flat": each object in its colour of `colors`; "base": each with its base
// colour and texture, without light; otherwise with the materials that the file has. Without a background it stays
// transparent.
window.draw = async ({url, width, height, background, look, colors}) => {
  const model = await load(url);
  const renderer = rendererOf(width, height);
  model.scene.traverse((node) => {
    if (!node.isMesh) return;
    const {map, color, side} = node.material;
    if (map) map.anisotropy = renderer.capabilities.getMaxAnisotropy();
    if (look === 'flat') node.material = new MeshBasicMaterial({color: new Color(...colors[nameOf(node)]), side});
    if (look === 'base') node.material = new MeshBasicMaterial({map, color, side});
  });
  const scene = new Scene();
  if (background) scene.background = new Color(...background);
  scene.add(model.scene);
  scene.updateMatrixWorld(true);
  const camera = model.cameras[0];
  if (!(Math.abs(camera.aspect * height - width) < 1e-3)) throw new Error(`the camera's aspect ratio is ${camera.aspect}`);
  renderer.setClearAlpha(background ? 1 : 0);
  renderer.render(scene, camera);
  return renderer.domElement.toDataURL('image/png');
};

// Each mesh where it stands: triangles, bounds, material and the size of its texture.
window.describe = async (url) => {
  const model = await load(url);
  const meshes = [];
  model.scene.traverse((node) => {
    if (!node.isMesh) return;
    const {index, attributes} = node.geometry;
    const box = new Box3().setFromObject(node, true);
    const {name, map, color, roughness, metalness, transmission, type} = node.material;
    meshes.push({
      name: nameOf(node), triangles: (index ?? attributes.position).count / 3, min: box.min.toArray(), max: box.max.toArray(),
      material: {name, type, color: color.toArray(), roughness, metalness, transmission: transmission ?? 0},
      texture: map && [map.image.width, map.image.height],
    });
  });
  return meshes;
};
