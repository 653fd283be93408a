// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A sweep of 10 million triangles without a texture, from its meshes in memory to the .glb on disk, beside a
// plain write of the same bytes that waits for the disk (fdatasync). Both make a new file each time.
//
// Usage: bench_gltf_speed [FOLDER]   where the files are written; the temporary folder without it

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "harness.hpp"
#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/output_file.hpp"

namespace {

namespace bench = sweepkit::bench;
namespace fs = std::filesystem;
namespace scene = sweepkit::scene;

constexpr int kRounds = 5;

const char* const kTube = R"({"sweepkit": 1, "objects": [{"name": "tube",
  "tessellation": {"contour": 2000, "trajectory": 2500},
  "sweep": {"contour": {"circle": {"radius": 0.1}}, "caps": "none",
            "trajectory": {"helix": {"radius": 1, "pitch": 0.5, "turns": 4}}}}]})";

void write_plainly(const fs::path& file, std::span<const std::byte> bytes) {
  const int number = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (number < 0) throw std::runtime_error(file.string() + ": cannot be made");
  while (!bytes.empty()) {
    const ssize_t count = ::write(number, bytes.data(), bytes.size());
    if (count <= 0) throw std::runtime_error(file.string() + ": cannot be written");
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  if (::fdatasync(number) != 0 || ::close(number) != 0)
    throw std::runtime_error(file.string() + ": cannot be written");
}

// What the process took at most so far, bytes.
std::size_t peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kib = 0;
    if (word == "VmHWM:" && status >> kib) return 1024 * kib;
  }
  return 0;
}

int compare_ways(const fs::path& folder) {
  const scene::Document document = scene::parse_document(kTube, "tube.json");
  const scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kMeshFile});
  const scene::Model model = scene::build(document, plan);
  const scene::GltfOptions options = {};
  const std::size_t before = peak_memory();
  { const scene::GltfPieces made = scene::make_gltf_pieces(model.scene, plan, "tube.glb", options); }
  const std::size_t most = peak_memory() - before;
  const scene::GltfFile reference = scene::make_gltf(model.scene, plan, "tube.glb", options);
  const std::vector<std::byte>& bytes = reference.files.back().bytes;
  std::printf("%zu triangles, %zu bytes; the writer took %.2f times these at most beside the meshes\n",
              model.scene.meshes[0].triangles.size(), bytes.size(),
              static_cast<double>(most) / static_cast<double>(bytes.size()));

  const fs::path file = folder / "tube.glb";
  const auto prepare = [&] { fs::remove(file); };
  const auto check = [&]() -> std::string {
    return fs::file_size(file) == bytes.size() ? "" : "another size";
  };
  const bench::Contender plain = {"write_and_fdatasync", [&] { write_plainly(file, bytes); }, check, prepare};
  const auto make = [&](const scene::GltfOptions& how) {
    const scene::GltfPieces made = scene::make_gltf_pieces(model.scene, plan, "tube.glb", how);
    scene::write_files(std::vector<scene::OutputFile>{{file, {}, made.files.back().pieces}});
  };
  const bench::Contender ours = {"make_gltf_and_write", [&] { make(options); }, check, prepare};
  const bench::Contender synced = {"make_gltf_write_and_fdatasync",
                                   [&] {
                                     make(options);
                                     const int number = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
                                     if (number < 0 || ::fdatasync(number) != 0 || ::close(number) != 0)
                                       throw std::runtime_error("cannot wait for the disk");
                                   },
                                   check, prepare};
  const bench::Comparison comparison = bench::compare("glb_of_10m_triangles", {plain, ours, synced}, kRounds);
  std::fputs(bench::to_table(comparison).c_str(), stdout);
  fs::remove(file);
  constexpr double kMost = 3;
  return comparison.results[2].ratio.median <= kMost ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const fs::path folder = argc > 1 ? fs::path(argv[1]) : fs::temp_directory_path();
    return compare_ways(folder);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_gltf_speed: %s\n", error.what());
    return 2;
  }
}
