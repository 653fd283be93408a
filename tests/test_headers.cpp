// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Holds nothing: CMake hangs the headers that tests share on a target, and a target has a source.
