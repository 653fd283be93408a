// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::sweep {

/// tangent(segment, t) for a caller that has evaluated the segment there already.
template <int D>
Vector<D> tangent_of(const Segment<D>& segment, double t, const CurvePoint<D>& here);

}  // namespace sweepkit::sweep
