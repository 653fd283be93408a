// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Runs in the browser: draws a .glb with the camera, the materials and the lights that it holds and with no other
// light, linear light by light until the screen's own encoding.
import {Color, NoToneMapping, Scene, SRGBColorSpace, WebGLRenderer} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

window.drawLit = async ({glb, size}) => {
  const bytes = Uint8Array.from(atob(glb), (c) => c.charCodeAt(0));
  const model = await new GLTFLoader().parseAsync(bytes.buffer, '');
  const renderer = new WebGLRenderer({antialias: false, preserveDrawingBuffer: true});
  renderer.setPixelRatio(1);
  renderer.setSize(size, size);
  renderer.toneMapping = NoToneMapping;
  renderer.outputColorSpace = SRGBColorSpace;
  const scene = new Scene();
  scene.background = new Color(0, 0, 0);
  scene.add(model.scene);
  scene.updateMatrixWorld(true);
  renderer.render(scene, model.cameras[0]);
  return renderer.domElement.toDataURL('image/png');
};
