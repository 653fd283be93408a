// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "image_module.hpp"

#include <dlfcn.h>
#include <link.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <new>

#include "sweepkit/error.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace sweepkit::texmap {
namespace {

std::atomic<bool> is_loaded = false;

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

const ImageModule& load() {
  require_room();
  std::string tried;
  const std::filesystem::path folder = own_folder();
  for (const std::filesystem::path& candidate :
       {folder / kImageModuleFile, folder / "../lib/sweepkit" / kImageModuleFile,
        folder / "sweepkit" / kImageModuleFile,
        // By its bare name: where this code's own run path leads, which is the place that the installed
        // library has given to the program that links it.
        std::filesystem::path(kImageModuleFile)}) {
    if (void* library = dlopen(candidate.c_str(), RTLD_NOW | RTLD_LOCAL)) {
      if (const void* table = dlsym(library, kImageModuleSymbol)) {
        is_loaded = true;
        return *static_cast<const ImageModule*>(table);
      }
    }
    const char* reason = dlerror();
    // A limit of the address space that the module's own libraries do not fit in.
    if (reason != nullptr && std::strstr(reason, "failed to map segment") != nullptr) throw std::bad_alloc();
    tried += (tried.empty() ? "" : "; ") + std::string(reason != nullptr ? reason : candidate.c_str());
  }
  throw OutputError("the image module cannot be loaded (" + tried + "); install sweepkit whole");
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

}  // namespace

// Loaded once a process, by whichever thread comes first.
const ImageModule& image_module() {
  static const ImageModule& loaded = load();
  return loaded;
}

bool is_image_module_loaded() {
  return is_loaded;
}

void check_image_exists(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (!std::filesystem::exists(status)) throw InputError({.file = file.string()}, "no such file");
  if (std::filesystem::is_directory(status))
    throw InputError({.file = file.string()}, "is a folder, not an image");
}

void throw_if_unreadable(const std::filesystem::path& file, const std::string& problem) {
  if (problem == kOutOfMemory) throw std::bad_alloc();
  if (!problem.empty())
    throw InputError({.file = file.string()}, "cannot be read as an image: " + one_line(problem));
}

void throw_if_not_encoded(const std::string& problem) {
  if (problem == kOutOfMemory) throw std::bad_alloc();
  if (!problem.empty()) throw OutputError("cannot encode the image: " + one_line(problem));
}

}  // namespace sweepkit::texmap
