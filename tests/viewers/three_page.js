// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Runs in the browser: draws a .glb with the camera that it holds, without light, so that each pixel is the colour of
// the surface there. Either each object in a colour of its own, or each with its base colour and texture.
import {Color, MeshBasicMaterial, NoToneMapping, Scene, SRGBColorSpace, WebGLRenderer} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

window.draw = async ({glb, width, height, background, colors}) => {
  const bytes = Uint8Array.from(atob(glb), (c) => c.charCodeAt(0));
  const model = await new GLTFLoader().parseAsync(bytes.buffer, '');

  const renderer = new WebGLRenderer({antialias: false, preserveDrawingBuffer: true});
  renderer.setPixelRatio(1);
  renderer.setSize(width, height);
  renderer.toneMapping = NoToneMapping;
  renderer.outputColorSpace = SRGBColorSpace;

  model.scene.traverse((node) => {
    if (!node.isMesh) return;
    const {map, color, side} = node.material;
    // three.js turns the spaces of a node's name into underscores.
    const flat = colors && colors[node.userData.name ?? node.name];
    if (map) map.anisotropy = renderer.capabilities.getMaxAnisotropy();
    node.material = flat ? new MeshBasicMaterial({color: new Color(...flat), side}) : new MeshBasicMaterial({map, color, side});
  });
  const scene = new Scene();
  scene.background = new Color(...background);
  scene.add(model.scene);
  scene.updateMatrixWorld(true);
  const camera = model.cameras[0];
  camera.aspect = width / height;
  camera.updateProjectionMatrix();
  renderer.render(scene, camera);
  return renderer.domElement.toDataURL('image/png');
};
