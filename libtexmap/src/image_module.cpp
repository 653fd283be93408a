// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "image_module.hpp"

#include <algorithm>
#include <atomic>
#include <new>

#include "module_file.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace sweepkit::texmap {
namespace {

std::atomic<bool> is_loaded = false;

const ImageModule& load() {
  std::string tried;
  const void* table = module_symbol(kImageModuleFile, kImageModuleSymbol, tried);
  if (table == nullptr)
    throw OutputError("the image module cannot be loaded (" + tried + "); install sweepkit whole");
  is_loaded = true;
  return *static_cast<const ImageModule*>(table);
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

void load_image_module() {
  image_module();
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
