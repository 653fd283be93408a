// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Runs in the browser: draws a .glb with the camera that it holds, linear light by light until the screen's own
// encoding: with its own materials and lights; or where a `sun` shines in that direction, under that light alone and
// matt, with colours and normal maps as the loader gives them, their green turned round where `turnsGreen` says so.
import {Color, DirectionalLight, MeshLambertMaterial, NoToneMapping, Scene, SRGBColorSpace, WebGLRenderer} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

function makeMatt(model, anisotropy, turnsGreen) {
  model.traverse((node) => {
    if (node.isLight) node.visible = false;
    if (!node.isMesh) return;
    const {map, color, side, normalMap, normalScale} = node.material;
    for (const texture of [map, normalMap]) {
      if (texture) texture.anisotropy = anisotropy;
    }
    node.material = new MeshLambertMaterial({map, color, side, normalMap, normalScale: normalScale.clone()});
    if (turnsGreen) node.material.normalScale.y *= -1;
  });
}

window.draw = async ({url, size, sun, turnsGreen}) => {
  const model = await new GLTFLoader().loadAsync(url);
  const renderer = new WebGLRenderer({antialias: false, preserveDrawingBuffer: true});
  renderer.setPixelRatio(1);
  renderer.setSize(size, size);
  renderer.toneMapping = NoToneMapping;
  renderer.outputColorSpace = SRGBColorSpace;
  const scene = new Scene();
  scene.background = new Color(0, 0, 0);
  scene.add(model.scene);
  if (sun) {
    makeMatt(model.scene, renderer.capabilities.getMaxAnisotropy(), turnsGreen);
    // Lambert's law in three.js divides by pi: the light has it back.
    const light = new DirectionalLight(0xffffff, Math.PI);
    light.position.set(...sun.map((x) => -x));
    scene.add(light);
  }
  scene.updateMatrixWorld(true);
  const camera = model.cameras[0];
  camera.aspect = 1;
  camera.updateProjectionMatrix();
  renderer.render(scene, camera);
  return renderer.domElement.toDataURL('image/png');
};
