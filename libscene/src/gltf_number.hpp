// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

namespace sweepkit::scene {

/// The float's shortest decimal, as the double that JSON tells in those few digits: 0.42, not
/// 0.41999998688697815. Viewers read both as the same float.
double in_few_digits(float value);

}  // namespace sweepkit::scene
