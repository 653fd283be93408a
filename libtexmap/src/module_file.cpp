// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "module_file.hpp"

#include <dlfcn.h>
#include <link.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>

namespace sweepkit::texmap {
namespace {

// The folder of the program or shared library that holds this code. A program has no name in its link map,
// and argv[0] may name anything that lies in the working folder: the system is asked instead.
std::filesystem::path own_folder() {
  Dl_info info{};
  link_map* map = nullptr;
  std::error_code ignored;
  if (dladdr1(reinterpret_cast<const void*>(&own_folder), &info, reinterpret_cast<void**>(&map),
              RTLD_DL_LINKMAP) != 0 &&
      map != nullptr && map->l_name != nullptr && map->l_name[0] != '\0') {
    return std::filesystem::canonical(map->l_name, ignored).parent_path();
  }
  return std::filesystem::canonical("/proc/self/exe", ignored).parent_path();
}

// Address space that the module's libraries take when they are loaded: 620 MB measured, and threads. Where a
// limit leaves less, constructors inside those libraries end the program, which nobody can catch.
constexpr std::uint64_t kModuleRoom = std::uint64_t{768} << 20;

void require_room() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const std::uint64_t used = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  if (limit.rlim_cur < used + kModuleRoom) throw std::bad_alloc();
}

}  // namespace

const void* module_symbol(const char* file, const char* symbol, std::string& tried) {
  require_room();
  const std::filesystem::path folder = own_folder();
  for (const std::filesystem::path& candidate :
       {folder / file, folder / "../lib/sweepkit" / file, folder / "sweepkit" / file,
        // By its bare name: where this code's own run path leads, which is the place that the installed
        // library has given to the program that links it.
        std::filesystem::path(file)}) {
    if (void* library = dlopen(candidate.c_str(), RTLD_NOW | RTLD_LOCAL)) {
      if (const void* found = dlsym(library, symbol)) return found;
    }
    const char* reason = dlerror();
    // A limit of the address space that the module's own libraries do not fit in.
    if (reason != nullptr && std::strstr(reason, "failed to map segment") != nullptr) throw std::bad_alloc();
    tried += (tried.empty() ? "" : "; ") + std::string(reason != nullptr ? reason : candidate.c_str());
  }
  return nullptr;
}

}  // namespace sweepkit::texmap
