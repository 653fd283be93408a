// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

// What the libraries promise - no NaN, hits that are watertight, frames that close, the same bytes on every
// machine - rests on IEEE 754 as it stands. -ffast-math folds every check for NaN away and reorders the sums
// whose order the proofs are about (docs/stability.md shows which cases break).
//
// A test that shows just that compiles a few sources so on purpose.
#ifndef SWEEPKIT_FAST_MATH_ON_PURPOSE
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "sweepkit needs strict floating point: build it without -ffast-math (remedy: -fno-fast-math behind it)"
#endif
#endif
