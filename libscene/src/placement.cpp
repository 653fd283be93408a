// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {}
