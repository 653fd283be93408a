// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The file's animations, all at once and over and over.
import {AnimationMixer} from 'three';

const kLongestStep = 0.1;  // seconds; a page that was hidden goes on where it was

export class Motion {
  constructor(model, clips, stage) {
    this.stage = stage;
    this.mixer = new AnimationMixer(model);
    for (const clip of clips) this.mixer.clipAction(clip).play();
    this.isPlaying = false;
  }

  toggle() {
    this.isPlaying = !this.isPlaying;
    this.last = undefined;
    if (this.isPlaying) this.step();
  }

  step() {
    requestAnimationFrame((now) => {
      if (!this.isPlaying) return;
      this.mixer.update(Math.min((now - (this.last ?? now)) / 1000, kLongestStep));
      this.last = now;
      this.stage.draw();
      this.step();
    });
  }
}
