// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Runs in the browser: draws a .glb with the camera that it holds under one directional light, matt, with colours and
// normal maps as the loader gives them. Lambert's law here divides by pi: the light has it back.
import {Color, DirectionalLight, MeshLambertMaterial, NoToneMapping, Scene, SRGBColorSpace, WebGLRenderer} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

window.draw = async ({glb, width, height, direction, turnsGreen}) => {
  const bytes = Uint8Array.from(atob(glb), (c) => c.charCodeAt(0));
  const model = await new GLTFLoader().parseAsync(bytes.buffer, '');

  const renderer = new WebGLRenderer({antialias: false, preserveDrawingBuffer: true});
  renderer.setPixelRatio(1);
  renderer.setSize(width, height);
  renderer.toneMapping = NoToneMapping;
  renderer.outputColorSpace = SRGBColorSpace;

  model.scene.traverse((node) => {
    if (node.isLight) node.visible = false;  // the file's own
    if (!node.isMesh) return;
    const {map, color, side, normalMap, normalScale} = node.material;
    for (const texture of [map, normalMap]) {
      if (texture) texture.anisotropy = renderer.capabilities.getMaxAnisotropy();
    }
    node.material = new MeshLambertMaterial({map, color, side, normalMap, normalScale: normalScale.clone()});
    if (turnsGreen) node.material.normalScale.y *= -1;
  });
  const scene = new Scene();
  scene.background = new Color(0, 0, 0);
  scene.add(model.scene);
  const light = new DirectionalLight(0xffffff, Math.PI);
  light.position.set(...direction.map((x) => -x));
  scene.add(light);
  scene.updateMatrixWorld(true);
  const camera = model.cameras[0];
  camera.aspect = width / height;
  camera.updateProjectionMatrix();
  renderer.render(scene, camera);
  return renderer.domElement.toDataURL('image/png');
};
