// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Runs in the browser: draws a .glb with its own camera, materials and lights into linear floats, which are neither
// clipped nor encoded. With `isBeforeWhite` the file's lights are off and all round is an environment of radiance 1,
// of which only what is mirrored counts: the base colour of what is no metal is what it scatters or lets through, and is
// made black.
import {DataTexture, EquirectangularReflectionMapping, FloatType, Scene, WebGLRenderer, WebGLRenderTarget} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

// three.js blurs an environment for each roughness (PMREM), from cubes whose sides are a quarter of the width. It needs
// that many texels: of 256 all round the blurred ones come out black, of 64 too dark.
function whiteEnvironment() {
  const width = 1024;
  const height = 512;
  const environment = new DataTexture(new Float32Array(4 * width * height).fill(1), width, height, undefined, FloatType);
  environment.mapping = EquirectangularReflectionMapping;
  environment.needsUpdate = true;
  return environment;
}

let renderer;
let environment;

// [r, g, b] of each pixel, rows from the top.
window.measure = async ({url, width, height, isBeforeWhite}) => {
  renderer ??= new WebGLRenderer({antialias: false});
  const model = await new GLTFLoader().loadAsync(url);
  const scene = new Scene();
  scene.add(model.scene);
  if (isBeforeWhite) {
    environment ??= whiteEnvironment();
    scene.environment = environment;
    model.scene.traverse((node) => {
      if (node.isLight) node.visible = false;
      if (node.isMesh && node.material.metalness === 0) node.material.color.set(0, 0, 0);
    });
  }
  scene.updateMatrixWorld(true);
  const target = new WebGLRenderTarget(width, height, {type: FloatType});
  renderer.setRenderTarget(target);
  renderer.render(scene, model.cameras[0]);
  const pixels = new Float32Array(4 * width * height);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
  target.dispose();
  return Array.from({length: width * height}, (_, i) => {
    const at = 4 * ((height - 1 - Math.floor(i / width)) * width + (i % width));
    return [...pixels.subarray(at, at + 3)];
  });
};
