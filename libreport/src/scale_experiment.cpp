// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "scale_experiment.hpp"

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "child_output.hpp"
#include "scale_scenes.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::report {
namespace {

// A folder of its own under the system's temporary one, removed at the end.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "sweepkit-scale-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw OutputError(name + ": cannot be made");
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct Sizes {
  std::vector<double> triangles;
  std::vector<int> texture_sides;
  std::vector<int> objects;
  std::vector<int> threads = {1, 2, 3, 4};
  int side;              // of a picture
  int threads_side;      // of that which several threads draw
  double few_triangles;  // of a scene whose size is not what is looked at
};

Sizes sizes_for(const Effort& effort) {
  if (effort.is_quick) {
    return {.triangles = {1e3, 1e4, 3e4, 1e5},
            .texture_sides = {64, 128, 256, 512},
            .objects = {1, 10, 30, 100},
            .side = 32,
            .threads_side = 64,
            .few_triangles = 1e4};
  }
  return {.triangles = {1e3, 1e4, 1e5, 1e6, 1e7},
          .texture_sides = {256, 512, 1024, 2048, 4096},
          .objects = {1, 10, 100, 1000},
          .side = 128,
          .threads_side = 512,
          .few_triangles = 1e5};
}

class Measurer {
 public:
  Measurer(const Effort& effort, Table& table) : effort_(effort), sizes_(sizes_for(effort)), table_(table) {
    steps_ = 3 * (sizes_.triangles.size() + sizes_.texture_sides.size() + sizes_.objects.size()) +
             2 * sizes_.threads.size();
  }

  void measure() {
    for (const double triangles : sizes_.triangles) {
      write_scene(knots_scene(triangles, 1, ""));
      measure_all("triangles", triangles);
    }
    for (const int side : sizes_.texture_sides) {
      write_noise(folder_.path() / "noise.png", side);
      write_scene(knots_scene(sizes_.few_triangles, 1, "noise.png"));
      measure_all("texture side", side);
    }
    for (const int objects : sizes_.objects) {
      // As many triangles in all, until each has its fewest.
      write_scene(knots_scene(sizes_.few_triangles, objects, ""));
      measure_all("objects", objects);
    }
    write_scene(knots_scene(sizes_.few_triangles, 1, ""));
    for (const int threads : sizes_.threads) {
      for (const std::string work : {"render", "render 3x3"})
        measure_one("threads", threads, work, threads, sizes_.threads_side);
    }
  }

 private:
  void write_scene(const std::string& text) const {
    if (!(std::ofstream(folder_.path() / "scene.json") << text))
      throw OutputError((folder_.path() / "scene.json").string() + ": cannot be written");
  }

  void measure_all(const std::string& against, double size) {
    for (const std::string work : {"generate", "render", "export"})
      measure_one(against, size, work, 1, sizes_.side);
  }

  void measure_one(const std::string& against, double size, const std::string& work, int threads, int side) {
    effort_.tell(done_++ / static_cast<double>(steps_));
    const std::optional<std::string> told = child_output(
        effort_.program, {"report", "--scale-step", work, (folder_.path() / "scene.json").string(),
                          std::to_string(threads), std::to_string(side)});
    std::vector<Cell> row{against, work, size};
    std::istringstream words(told.value_or(""));
    for (int i = 0; i < 5; ++i) {
      std::string word = "nan";  // what fails stays in the table
      words >> word;
      row.emplace_back(std::strtod(word.c_str(), nullptr));
    }
    table_.rows.push_back(std::move(row));
  }

  const Effort& effort_;
  Sizes sizes_;
  Table& table_;
  Folder folder_;
  std::size_t steps_ = 0;
  double done_ = 0;
};

}  // namespace

Experiment measure_scale(const Effort& effort) {
  Experiment experiment{
      .name = "scale",
      .title = "Time and memory against size",
      .what =
          "Generating meshes, rendering a picture and exporting a .glb (in memory), each alone: of tubes "
          "about "
          "a trefoil knot, against the number of triangles, the side of a texture, the number of objects, "
          "and "
          "rendering against threads.",
      .how =
          "Each step runs in a process of its own. Its memory is the largest resident size that the kernel "
          "tells "
          "(VmHWM, forgotten before the step by clear_refs) above the resident size before it, in the second "
          "run; "
          "its time is the median of the runs after that. One thread, but where threads are counted."};
  experiment.table.columns = {{"against", "against"},
                              {"work", "work"},
                              {"size", "size"},
                              {"seconds", "time (s)"},
                              {"seconds_least", "least of the runs (s)"},
                              {"seconds_most", "most of the runs (s)"},
                              {"runs", "runs"},
                              {"bytes", "memory (bytes)"}};
  Measurer(effort, experiment.table).measure();
  for (const std::string against : {"triangles", "texture side", "objects", "threads"}) {
    const std::string name = "scale_" + (against == "texture side" ? std::string("texture") : against);
    const Plot time{.name = name,
                    .title = "time against " + against,
                    .x = "size",
                    .y = "seconds",
                    .by = "work",
                    .only = "against",
                    .only_is = against};
    experiment.plots.push_back(time);
    experiment.plots.push_back(time);
    experiment.plots.back().name += "_memory";
    experiment.plots.back().title = "memory against " + against;
    experiment.plots.back().y = "bytes";
  }
  return experiment;
}

}  // namespace sweepkit::report
