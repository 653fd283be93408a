// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Ways of showing surfaces. Each mesh keeps the material that it came with.
import {
  CanvasTexture, DoubleSide, Mesh, MeshBasicMaterial, MeshNormalMaterial, MeshStandardMaterial, RepeatWrapping, SRGBColorSpace,
} from 'three';

/** Key, name on the button, what it is good for. */
export const kLooks = [
  ['finished', 'Finished', 'With its materials and textures'],
  ['checker', '(u,v)', 'A checker on the texture coordinates: one period of both is 8 x 8 fields'],
  ['normals', 'Normals', 'Which way the surface faces, seen from the camera'],
  ['clay', 'Clay', 'Shape alone'],
];

// Fields of two greys, letters and numbers in them: a mirrored texture shows.
function checkerTexture(anisotropy) {
  const side = 1024;
  const field = side / 8;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = side;
  const pen = canvas.getContext('2d');
  pen.font = `600 ${field / 2.4}px sans-serif`;
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  for (let row = 0; row < 8; ++row) {
    for (let column = 0; column < 8; ++column) {
      const isDark = (row + column) % 2 === 1;
      pen.fillStyle = isDark ? `hsl(${45 * column} 45% 42%)` : '#e9e6df';
      pen.fillRect(column * field, row * field, field, field);
      pen.fillStyle = isDark ? '#ffffff' : '#555555';
      pen.fillText('ABCDEFGH'[column] + (8 - row), (column + 0.5) * field, (row + 0.53) * field);
    }
  }
  const texture = new CanvasTexture(canvas);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.flipY = false;  // as glTF's own
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = anisotropy;
  return texture;
}

export class Looks {
  constructor(model, anisotropy) {
    this.meshes = [];
    model.traverse((node) => {
      if (node.isMesh) this.meshes.push(node);
    });
    this.own = this.meshes.map((mesh) => mesh.material);
    for (const material of this.own) if (material.map) material.map.anisotropy = anisotropy;
    this.anisotropy = anisotropy;
    this.made = {};
    this.wires = null;
  }

  material(look) {
    this.made[look] ??= {
      checker: () => new MeshStandardMaterial({map: checkerTexture(this.anisotropy), roughness: 0.9, side: DoubleSide}),
      normals: () => new MeshNormalMaterial({side: DoubleSide}),
      clay: () => new MeshStandardMaterial({color: 0xb9b4aa, roughness: 0.85, side: DoubleSide}),
    }[look]();
    return this.made[look];
  }

  show(look) {
    this.meshes.forEach((mesh, i) => {
      mesh.material = look === 'finished' ? this.own[i] : this.material(look);
    });
  }

  /** Edges over the surfaces; made when they are first asked for. */
  showWires(isShown) {
    if (!this.wires && isShown) {
      const material = new MeshBasicMaterial({
        wireframe: true, color: 0x0b62c4, transparent: true, opacity: 0.55, polygonOffset: true, polygonOffsetFactor: -1,
        polygonOffsetUnits: -1,
      });
      this.wires = this.meshes.map((mesh) => {
        const wire = new Mesh(mesh.geometry, material);
        wire.raycast = () => {};
        wire.morphTargetInfluences = mesh.morphTargetInfluences;
        mesh.add(wire);
        return wire;
      });
    }
    for (const wire of this.wires ?? []) wire.visible = isShown;
  }
}
