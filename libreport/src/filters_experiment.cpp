// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "filters_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <future>
#include <memory>
#include <span>

#include "filter_methods.hpp"
#include "plane_view.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/texmap/image_error.hpp"
#include "timing.hpp"

namespace sweepkit::report {
namespace {

struct Picture {
  std::string name;  // of the plots' files
  std::string title;
  double turn_deg;
  PlaneTexture (*texture)(int side);
};

const std::vector<Picture> kPictures = {{"checker_0", "checker", 0, checker_texture},
                                        {"checker_35", "checker turned by 35 degrees", 35, checker_texture},
                                        {"noise_35", "noise turned by 35 degrees", 35, noise_texture}};

// The texture is twice as many texels a side as the picture is pixels, whatever that is: the same footprints.
struct Sizes {
  int picture, texture;
};
// Of so many rows one is timed, near and far.
constexpr int kTimedRows = 4;

// The rows of the picture that are on the plane.
texmap::Image to_picture(const PlaneView& view, const std::vector<PlanePixel>& pixels,
                         const std::vector<float>& values) {
  texmap::Image image = texmap::make_float_image(view.side(), view.side() - pixels.front().y);
  auto& texels = std::get<std::vector<float>>(image.texels);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) texels[3 * i + k] = values[i];
  }
  return image;
}

class OpenPeer {
 public:
  OpenPeer(const TexturePeer* peer, const PlaneTexture& texture) : peer_(peer) {
    if (peer_ == nullptr) return;
    const std::string problem = peer_->open(texture.texels.data(), texture.side, handle_);
    if (!problem.empty()) throw OutputError("OpenImageIO's texture system: " + problem);
  }
  ~OpenPeer() {
    if (handle_ != nullptr) peer_->close(handle_);
  }
  OpenPeer(const OpenPeer&) = delete;
  OpenPeer& operator=(const OpenPeer&) = delete;

  void sample(const PeerOptions& options, const std::vector<texmap::Footprint>& footprints,
              std::vector<float>& out) const {
    peer_->sample(handle_, options, footprints.data(), footprints.size(), out.data());
  }

 private:
  const TexturePeer* peer_;
  void* handle_ = nullptr;
};

struct Reference {
  std::string filter;
  texmap::Image picture;
  double error;
};

struct Score {
  double psnr, rmse, flip;
};

Score score_of(const texmap::Image& made, const texmap::Image& reference) {
  return {texmap::psnr(made, reference), texmap::rmse(made, reference), texmap::mean_flip(made, reference)};
}

void measure_picture(const Picture& picture, const Sizes& sizes, const TexturePeer* module,
                     const Effort& effort, Table& table) {
  const PlaneView view(sizes.picture, picture.turn_deg);
  const PlaneTexture texture = picture.texture(sizes.texture);
  const std::vector<PlanePixel> pixels = plane_pixels(view);
  std::vector<texmap::Footprint> footprints;
  std::vector<texmap::Footprint> timed;
  footprints.reserve(pixels.size());
  for (const PlanePixel& pixel : pixels) {
    footprints.push_back(pixel.footprint);
    if (pixel.y % kTimedRows == 0) timed.push_back(pixel.footprint);
  }
  const PlaneReference exact = plane_reference(view, texture, pixels);
  const auto picture_of = [&](const std::vector<double>& values) {
    return to_picture(view, pixels, {values.begin(), values.end()});
  };
  const std::vector<Reference> references = {{"tent", picture_of(exact.tent), exact.tent_error},
                                             {"box", picture_of(exact.box), exact.box_error}};

  const std::vector<FilterMethod> methods = filter_methods(effort.is_quick, module != nullptr);
  const OpenPeer peer(module, texture);
  const texmap::ImageTexture image{to_image(texture)};
  texmap::TileCache cache;
  texmap::FilterThread thread(cache);
  std::vector<std::unique_ptr<texmap::TextureSampler>> samplers(texmap::kFilterNames.size());
  for (const FilterMethod& method : methods) {
    const auto* own = std::get_if<OwnLookup>(&method.lookup);
    if (own == nullptr) continue;
    auto& sampler = samplers[static_cast<std::size_t>(own->filter)];
    if (!sampler)
      sampler = std::make_unique<texmap::TextureSampler>(image, own->filter, cache,
                                                         static_cast<std::uint32_t>(own->filter));
  }
  const auto look_up_all = [&](const FilterMethod& method, const std::vector<texmap::Footprint>& of,
                               std::vector<float>& out) {
    if (const auto* options = std::get_if<PeerOptions>(&method.lookup)) return peer.sample(*options, of, out);
    const auto& own = std::get<OwnLookup>(method.lookup);
    const texmap::TextureSampler& sampler = *samplers[static_cast<std::size_t>(own.filter)];
    for (std::size_t i = 0; i < of.size(); ++i) out[i] = look_up(sampler, own, of[i], thread);
  };
  std::vector<float> values(footprints.size());
  std::vector<std::function<void()>> calls;
  calls.reserve(methods.size());
  for (const FilterMethod& method : methods) {
    calls.emplace_back([&] {
      look_up_all(method, timed, values);
      keep(values);
    });
  }
  const std::vector<Timing> timings = time_in_turn(calls, effort);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    look_up_all(methods[m], footprints, values);
    const texmap::Image made = to_picture(view, pixels, values);
    // Both at once: FLIP takes more time than all that is timed here.
    std::vector<std::future<Score>> scores;
    scores.reserve(references.size());
    for (const Reference& reference : references) {
      scores.push_back(
          std::async(std::launch::async, [&made, &reference] { return score_of(made, reference.picture); }));
    }
    for (std::size_t r = 0; r < references.size(); ++r) {
      const Reference& reference = references[r];
      const Score score = scores[r].get();
      std::vector<Cell> row{picture.title + ", pixel filter: " + reference.filter,
                            picture.title,
                            reference.filter,
                            methods[m].name,
                            methods[m].setting,
                            score.psnr,
                            score.rmse,
                            score.flip,
                            reference.error};
      add_timing(row, timings[m].of_each(timed.size()));
      table.rows.push_back(std::move(row));
    }
  }
}

void add_plots(const Picture& picture, Experiment& experiment) {
  struct Measure {
    const char* name;
    const char* title;
  };
  for (const char* const filter : {"tent", "box"}) {
    for (const Measure& measure : {Measure{"rmse", "RMSE"}, {"psnr_db", "PSNR"}, {"flip", "FLIP"}}) {
      const bool is_psnr = std::string(measure.name) == "psnr_db";
      experiment.plots.push_back({.name = "filters_" + picture.name + "_" + filter + "_" + measure.name,
                                  .title = measure.title + std::string(", ") + picture.title +
                                           "; the reference's pixel filter: a " + filter,
                                  .x = "seconds",
                                  .y = measure.name,
                                  .by = "method",
                                  .only = "case",
                                  .only_is = picture.title + ", pixel filter: " + filter,
                                  .label = "setting",
                                  .is_y_log = !is_psnr,
                                  // Of points that are cheaper and lower; a PSNR is better the higher.
                                  .has_front = !is_psnr});
    }
  }
}

}  // namespace

Experiment measure_filters(const Effort& effort) {
  std::string reason;
  const TexturePeer* const peer = texture_peer(reason);
  return measure_filters_beside(effort, peer, reason);
}

Experiment measure_filters_beside(const Effort& effort, const TexturePeer* peer, const std::string& reason) {
  const Sizes sizes = effort.is_quick ? Sizes{128, 256} : Sizes{512, 1024};
  char size_text[120];
  std::snprintf(size_text, sizeof size_text,
                "A picture of %d pixels a side, a texture of %d texels a side that repeats. ", sizes.picture,
                sizes.texture);
  Experiment experiment{
      .name = "filters",
      .title = "Texture filters",
      .what =
          std::string("A plane that runs to the horizon, the exact footprint of each pixel known. ") +
          size_text +
          "The reference is 64 x 64 samples of the texture a pixel under a tent of one pixel each way, and "
          "beside it the 32 x 32 of them under a box of one pixel; column reference_error is what it may be "
          "off by itself. RMSE and PSNR are of linear light, FLIP is the mean over the picture, all without "
          "the sky. point and bilinear take more samples a pixel, the others cut long footprints; point, "
          "bilinear and box are made for a box, the others for a tent.",
      .how = peer != nullptr ? "All methods in turn on the footprints of every fourth row. OpenImageIO's "
                               "texture system reads float texels "
                               "of a tiled pyramid, all in its cache. One thread."
                             : "All methods in turn on the footprints of every fourth row. One thread. "
                               "OPENIMAGEIO'S TEXTURE SYSTEM IS "
                               "MISSING HERE: its module cannot be loaded (" +
                                   reason + ")."};
  Table& table = experiment.table;
  table.columns = {{"case", "picture and pixel filter"},
                   {"picture", "picture"},
                   {"pixel_filter", "the reference's pixel filter"},
                   {"method", "method"},
                   {"setting", "setting"},
                   {"psnr_db", "PSNR (dB), higher is better"},
                   {"rmse", "RMSE, linear light"},
                   {"flip", "mean FLIP"},
                   {"reference_error", "the reference's own error, RMSE"}};
  for (Column& column : timing_columns("one lookup")) table.columns.push_back(std::move(column));
  // A quick run leaves out the first, which is easier than the second and tells little else.
  const std::span<const Picture> pictures = std::span(kPictures).subspan(effort.is_quick ? 1 : 0);
  double done = 0;
  for (const Picture& picture : pictures) {
    measure_picture(picture, sizes, peer, effort, table);
    add_plots(picture, experiment);
    effort.tell(++done / static_cast<double>(pictures.size()));
  }
  return experiment;
}

}  // namespace sweepkit::report
