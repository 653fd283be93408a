// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace sweepkit::texmap {

/// What a module, a shared library that is loaded when it is first needed, calls by this name; looked for
/// beside the program, in ../lib/sweepkit, and by the program's own search path. nullptr where there is
/// none, and then `tried` says where it was looked for and why that failed. Throws std::bad_alloc if there is
/// no memory for it.
const void* module_symbol(const char* file, const char* symbol, std::string& tried);

}  // namespace sweepkit::texmap
