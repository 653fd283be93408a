// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Closed forms of what mirrors and shines: Whitted's terms, Fresnel's law, and glTF's microfacets (the specification's
// appendix B: D of GGX, height-correlated Smith masking, Schlick's F). Angles in radians.

/** Fresnel's law for unpolarized light that meets a denser body. */
export function fresnelExact(angle, ior) {
  const c = Math.cos(angle);
  const g = Math.sqrt(ior ** 2 - 1 + c ** 2);
  return 0.5 * ((g - c) / (g + c)) ** 2 * (1 + ((c * (g + c) - 1) / (c * (g - c) + 1)) ** 2);
}

export const f0Of = (ior) => ((ior - 1) / (ior + 1)) ** 2;
export const schlick = ({f0, f90}, cosine) => f0 + (f90 - f0) * (1 - cosine) ** 5;

/** Where Blinn's (N.H)^n is half as high as in the middle. */
export const blinnHalfWidth = (n) => Math.acos(0.5 ** (1 / n));

function heightOf(alpha2, nh) {
  return alpha2 / Math.PI / (nh ** 2 * (alpha2 - 1) + 1) ** 2;
}

// G / (4 N.L N.V).
function visibility(alpha2, nl, nv) {
  return 0.5 / (nl * Math.sqrt(alpha2 + (1 - alpha2) * nv ** 2) + nv * Math.sqrt(alpha2 + (1 - alpha2) * nl ** 2));
}

/** What comes back of a directional light of pi, by the microfacets alone. */
export function glint({nh, nl, nv, vh}, roughness, mirror) {
  const alpha2 = roughness ** 4;
  return Math.PI * nl * schlick(mirror, vh) * heightOf(alpha2, nh) * visibility(alpha2, nl, nv);
}

/**
 * The share of a white environment that microfacets send back at an angle of incidence, and the share that they send
 * back where each mirrors all of it: the rest of the light meets a second one. An integral over their normals H: with
 * dl = 4 V.H dh it is F D G V.H / (N.V N.H) dh, N.H D dh = dp, p = (1 - c^2) / (1 + c^2 (alpha^2 - 1)), c = N.H.
 */
export function mirroredShare(angle, roughness, mirror) {
  const alpha2 = roughness ** 4;
  const v = [Math.sin(angle), Math.cos(angle)];
  const kSteps = 200;  // halving them moves no share by 1e-3
  let share = 0;
  let all = 0;
  for (let i = 0; i < kSteps; ++i) {
    const p = (i + 0.5) / kSteps;
    const nh = Math.sqrt((1 - p) / (1 + p * (alpha2 - 1)));
    const sine = Math.sqrt(1 - nh ** 2);
    for (let j = 0; j < kSteps; ++j) {
      const vh = v[0] * sine * Math.cos(Math.PI * (j + 0.5) / kSteps) + v[1] * nh;
      const nl = 2 * vh * nh - v[1];
      if (!(vh > 0) || !(nl > 0)) continue;
      const weight = 4 * nl * visibility(alpha2, nl, v[1]) * vh / nh / kSteps ** 2;
      share += schlick(mirror, vh) * weight;
      all += weight;
    }
  }
  return {share, all};
}
