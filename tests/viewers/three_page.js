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
const nameOf = (node) => node.userData.name ?? node.name;

// Draws a file with the camera that it holds, without light, so that each pixel is the colour of the surface there.
// Either each object in a colour of its own, or each with its base colour and texture. Without a background it stays
// transparent.
window.draw = async ({url, width, height, background, colors}) => {
  const model = await load(url);
  const renderer = rendererOf(width, height);
  model.scene.traverse((node) => {
    if (!node.isMesh) return;
    const {map, color, side, opacity, transparent, depthWrite} = node.material;
    const flat = colors && colors[nameOf(node)];
    if (map) map.anisotropy = renderer.capabilities.getMaxAnisotropy();
    node.material = flat ? new MeshBasicMaterial({color: new Color(...flat), side})
                         : new MeshBasicMaterial({map, color, side, opacity, transparent, depthWrite});
  });
  const scene = new Scene();
  if (background) scene.background = new Color(...background);
  scene.add(model.scene);
  scene.updateMatrixWorld(true);
  const camera = model.cameras[0];
  camera.aspect = width / height;
  camera.updateProjectionMatrix();
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
