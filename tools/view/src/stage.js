// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The canvas: what is drawn, from where, in what light. Draws when something has changed and rests otherwise.
import {
  Box3, Color, NeutralToneMapping, PerspectiveCamera, PMREMGenerator, Scene, Sphere, Spherical, Vector3, WebGLRenderer,
} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {RoomEnvironment} from 'three/addons/environments/RoomEnvironment.js';

const kTurn = Math.PI / 24;  // by an arrow key
const kZoom = 0.9;           // by + and -
const kDimmed = 0.3;         // of the room, where the file brings lights of its own

export class Stage {
  constructor(canvas, model, cameras) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({canvas, antialias: true});
    this.renderer.toneMapping = NeutralToneMapping;
    this.scene = new Scene();
    this.scene.add(model);
    const generator = new PMREMGenerator(this.renderer);
    this.scene.environment = generator.fromScene(new RoomEnvironment(), 0.04).texture;
    generator.dispose();
    this.lights = 0;
    model.traverse(({isLight}) => {
      if (isLight) ++this.lights;
    });
    if (this.lights > 0) this.scene.environmentIntensity = kDimmed;

    this.model = model;
    this.model.updateMatrixWorld(true);
    this.bounds = new Box3().setFromObject(model).getBoundingSphere(new Sphere());
    if (!(this.bounds.radius > 0)) this.bounds.radius = 1;
    this.camera = new PerspectiveCamera(40, 1, 1, 10);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.controls.addEventListener('change', () => this.draw());
    this.sceneCamera = cameras[0];
    this.onResize = [];
    this.covered = {right: 0, bottom: 0};
    this.frame = {slope: Math.tan(Math.PI / 9), aspect: 1};  // what must be in view, up and down, and its shape
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
    this.reset();
  }

  /** The camera that the file brings; without one, everything in view. */
  reset() {
    if (!this.sceneCamera?.isPerspectiveCamera) return this.fit(this.bounds);
    const eye = this.sceneCamera.getWorldPosition(new Vector3());
    const ahead = this.sceneCamera.getWorldDirection(new Vector3());
    // Turned about what lies ahead: the point of the line of sight that is nearest to the middle of all.
    const reach = this.bounds.center.clone().sub(eye).dot(ahead);
    const target = eye.clone().addScaledVector(ahead, reach > 0 ? reach : this.bounds.radius);
    this.frame = {slope: Math.tan((Math.PI / 360) * this.sceneCamera.fov), aspect: this.sceneCamera.aspect};
    this.resize();
    this.look(eye, target);
  }

  /** A sphere fills the view, from where the camera is now or, at first, from the front and a little above. */
  fit(sphere) {
    const way = this.camera.position.clone().sub(this.controls.target);
    if (way.lengthSq() === 0 || this.wasNeverPlaced()) way.set(0.5, 0.45, 1);
    const narrow = Math.atan(this.frame.slope * Math.min(1, this.frame.aspect));
    const distance = (1.05 * Math.max(sphere.radius, 1e-9)) / Math.sin(narrow);
    this.look(sphere.center.clone().addScaledVector(way.normalize(), distance), sphere.center);
  }

  wasNeverPlaced() {
    return this.isPlaced !== true;
  }

  look(eye, target) {
    this.isPlaced = true;
    this.camera.position.copy(eye);
    this.controls.target.copy(target);
    this.controls.update();
    this.draw();
  }

  /** By so many steps of an arrow key. */
  turn(right, up) {
    const way = this.camera.position.clone().sub(this.controls.target);
    const at = new Spherical().setFromVector3(way);
    at.theta -= right * kTurn;
    at.phi -= up * kTurn;
    at.makeSafe();
    this.look(new Vector3().setFromSpherical(at).add(this.controls.target), this.controls.target.clone());
  }

  zoom(steps) {
    const way = this.camera.position.clone().sub(this.controls.target).multiplyScalar(kZoom ** steps);
    this.look(way.add(this.controls.target), this.controls.target.clone());
  }

  background(color) {
    this.scene.background = new Color(color);
    this.draw();
  }

  /** So many pixels at the right and at the bottom are under something. */
  cover(right, bottom) {
    this.covered = {right, bottom};
    this.resize();
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    // The frame lies in the middle of what is not covered, as large as it fits there.
    const {right, bottom} = this.covered;
    const {slope, aspect} = this.frame;
    const scale = Math.max(height / Math.max(height - bottom, 1), (aspect * height) / Math.max(width - right, 1));
    this.camera.fov = (360 / Math.PI) * Math.atan(slope * scale);
    this.camera.aspect = width / height;
    this.camera.setViewOffset(width, height, right / 2, bottom / 2, width, height);
    for (const tell of this.onResize) tell(width, height);
    this.draw();
  }

  draw() {
    this.isAsked ||= requestAnimationFrame(() => {
      this.isAsked = 0;
      this.controls.update();  // goes on by itself while the movement dies down
      const distance = this.camera.position.distanceTo(this.bounds.center);
      this.camera.near = Math.max(distance - 1.1 * this.bounds.radius, 1e-3 * Math.min(distance, this.bounds.radius), 1e-6);
      this.camera.far = distance + 1.1 * this.bounds.radius;
      this.camera.updateProjectionMatrix();
      this.renderer.render(this.scene, this.camera);
    });
  }
}
