// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The curves that the objects were made of, drawn through whatever hides them.
import {Group} from 'three';
import {Line2} from 'three/addons/lines/Line2.js';
import {LineGeometry} from 'three/addons/lines/LineGeometry.js';
import {LineMaterial} from 'three/addons/lines/LineMaterial.js';

/** Kind, name in the legend, colour. */
export const kCurves = {
  trajectory: ['Trajectory', 0xd9480f],
  contour: ['Contour', 0x099268],
  axis: ['Axis', 0x7048e8],
};

/** One group an object, by name: {name: {origin, curves: [{kind, points: [x, y, z, ...]}]}}. */
export function makeCurves(curvesByObject, stage) {
  const materials = Object.fromEntries(Object.entries(kCurves).map(([kind, [, color]]) => [
    kind,
    new LineMaterial({color, linewidth: kind === 'axis' ? 1.5 : 3, depthTest: false, transparent: true, dashed: false}),
  ]));
  stage.onResize.push((width, height) => {
    for (const material of Object.values(materials)) material.resolution.set(width, height);
  });
  const groups = {};
  for (const [name, {origin, curves}] of Object.entries(curvesByObject)) {
    const group = new Group();
    group.position.set(...origin);
    for (const {kind, points} of curves) {
      const line = new Line2(new LineGeometry().setPositions(points), materials[kind]);
      line.renderOrder = 10;
      group.add(line);
    }
    groups[name] = group;
    stage.scene.add(group);
  }
  stage.resize();
  return groups;
}
