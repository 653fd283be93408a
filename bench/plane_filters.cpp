// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Error against time of every filter, and of OpenImageIO's texture system beside them, on a plane that runs
// to the horizon: a texture of 1,024 texels a side that repeats, a picture of 512 pixels a side, the exact
// footprint of each pixel known. A checker along the plane's axes, the same turned by 35 degrees, and noise
// of equal strength in every octave, turned too. The reference takes 64 x 64 samples of the texture a pixel
// under a tent of one pixel each way (--box: under a box of one pixel, which all these filters are too wide
// for). One thread. Fails where it does not show what docs/algorithms/elliptical-average.md claims.
//
// Usage: plane_filters [--box] [--pictures FOLDER] [FILE.csv]

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "harness.hpp"
#include "sweepkit/texmap/image_error.hpp"
#include "sweepkit/texmap/image_file.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"

namespace {

using namespace sweepkit;

constexpr int kTexture = 1024;
constexpr int kPicture = 512;
constexpr int kReferenceSamples = 64;  // along each side of a tent

// A camera one unit above the plane y = 0, looking along -z and 20 degrees down, 60 degrees wide; the texture
// is two units wide and turned by `turn_deg`. Pixels within a degree of the horizon are left out.
class View {
 public:
  explicit View(double turn_deg)
      : turn_cos_(std::cos(radians(turn_deg))), turn_sin_(std::sin(radians(turn_deg))) {}

  std::optional<glm::dvec2> uv(glm::dvec2 pixel) const {
    const double x = (2 * pixel.x / kPicture - 1) * half_;
    const double y = (1 - 2 * pixel.y / kPicture) * half_;
    const double fall = -(y * pitch_cos_ + pitch_sin_);
    const double ahead = pitch_cos_ - y * pitch_sin_;
    if (fall < ahead * least_fall_) return std::nullopt;
    const glm::dvec2 at = glm::dvec2(x, ahead) / fall;
    return 0.5 * glm::dvec2(turn_cos_ * at.x - turn_sin_ * at.y, turn_sin_ * at.x + turn_cos_ * at.y);
  }

 private:
  static double radians(double degrees) { return degrees * std::numbers::pi / 180; }

  double turn_cos_;
  double turn_sin_;
  double pitch_cos_ = std::cos(radians(-20));
  double pitch_sin_ = std::sin(radians(-20));
  double half_ = std::tan(radians(30));
  double least_fall_ = std::tan(radians(1));
};

using Texels = std::vector<float>;  // grey

std::size_t texel_index(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

Texels checker() {
  Texels texels;
  for (int y = 0; y < kTexture; ++y) {
    for (int x = 0; x < kTexture; ++x) texels.push_back((x / 32 + y / 32) % 2 != 0 ? 0.9f : 0.05f);
  }
  return texels;
}

Texels noise() {
  std::vector<double> sum(kTexture * kTexture, 0.0);
  std::mt19937 random(7);
  for (int cells = 4; cells <= kTexture; cells *= 2) {
    std::vector<double> lattice(texel_index(0, cells, cells));
    for (double& value : lattice) value = std::uniform_real_distribution<>(-1, 1)(random);
    const auto at = [&](int x, int y) { return lattice[texel_index(x % cells, y % cells, cells)]; };
    for (int y = 0; y < kTexture; ++y) {
      for (int x = 0; x < kTexture; ++x) {
        const double gx = (x + 0.5) * cells / kTexture;
        const double gy = (y + 0.5) * cells / kTexture;
        const int ix = static_cast<int>(gx);
        const int iy = static_cast<int>(gy);
        const double fx = gx - ix;
        const double fy = gy - iy;
        sum[texel_index(x, y, kTexture)] += std::lerp(std::lerp(at(ix, iy), at(ix + 1, iy), fx),
                                                      std::lerp(at(ix, iy + 1), at(ix + 1, iy + 1), fx), fy);
      }
    }
  }
  Texels texels;
  for (const double value : sum)
    texels.push_back(static_cast<float>(std::clamp(0.5 + 0.16 * value, 0.0, 1.0)));
  return texels;
}

// 16-bit integers, as a decoded 8-bit file is kept.
std::shared_ptr<const texmap::Image> to_image(const Texels& texels) {
  std::vector<std::uint16_t> samples;
  for (const float value : texels) {
    for (int k = 0; k < 3; ++k) samples.push_back(static_cast<std::uint16_t>(std::lround(65535 * value)));
  }
  return std::make_shared<const texmap::Image>(texmap::Image{kTexture, kTexture, 3, samples});
}

struct Pixel {
  int x = 0;
  int y = 0;
  texmap::Footprint footprint;
};

std::vector<Pixel> pixels_of(const View& view) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < kPicture; ++y) {
    for (int x = 0; x < kPicture; ++x) {
      const glm::dvec2 at(x + 0.5, y + 0.5);
      if (!view.uv(at - glm::dvec2(0, 1.5))) continue;
      const auto difference = [&](const glm::dvec2& step) {
        return *view.uv(at + 0.5 * step) - *view.uv(at - 0.5 * step);
      };
      pixels.push_back({x, y, {*view.uv(at), difference({1, 0}), difference({0, 1})}});
    }
  }
  return pixels;
}

// Straight from the texels, by none of the code that is measured.
double reference_at(const View& view, const Texels& texels, const Pixel& pixel, bool is_box) {
  const auto texel_of = [](double turns) {
    return static_cast<std::size_t>((turns - std::floor(turns)) * kTexture) % kTexture;
  };
  double sum = 0;
  double weights = 0;
  for (int j = 0; j < kReferenceSamples; ++j) {
    for (int i = 0; i < kReferenceSamples; ++i) {
      glm::dvec2 offset = (glm::dvec2(i, j) + 0.5) / (0.5 * kReferenceSamples) - 1.0;
      double weight = (1 - std::abs(offset.x)) * (1 - std::abs(offset.y));
      if (is_box) {
        offset *= 0.5;
        weight = 1;
      }
      const glm::dvec2 uv = *view.uv(glm::dvec2(pixel.x + 0.5, pixel.y + 0.5) + offset);
      sum += weight * static_cast<double>(texels[texel_of(1 - uv.y) * kTexture + texel_of(uv.x)]);
      weights += weight;
    }
  }
  return sum / weights;
}

struct Column {
  std::string name;
  double turn_deg;
  Texels texels;
};

// How OpenImageIO's texture system is asked. Anisotropy 16 throughout: 64 brings nothing here. Texels of
// float spare it a conversion and are its fastest, 8 bits are no faster than 16. A wider or narrower
// footprint, and the filter that is not conservative, are worse in every column.
struct PeerSettings {
  OIIO::TypeDesc texels;
  OIIO::TextureOpt::InterpMode interpolation;
};

struct Method {
  std::string name;
  std::variant<texmap::Filter, PeerSettings> lookup;
  int most_parts = 1;  // of long footprints, cut along the major axis

  bool is_peer() const { return std::holds_alternative<PeerSettings>(lookup); }
};

class Peer {
 public:
  Peer(const Texels& texels, const PeerSettings& settings, const std::filesystem::path& file) {
    const OIIO::ImageSpec spec(kTexture, kTexture, 3, settings.texels);
    OIIO::ImageBuf image(spec);
    for (int y = 0; y < kTexture; ++y) {
      for (int x = 0; x < kTexture; ++x) {
        const float value = texels[texel_index(x, y, kTexture)];
        image.setpixel(x, y, OIIO::cspan<float>({value, value, value}));
      }
    }
    OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, image, file.string(), {});
    handle_ = system_->get_texture_handle(OIIO::ustring(file.string()));
    thread_ = system_->get_perthread_info();
    options_.swrap = options_.twrap = OIIO::TextureOpt::WrapPeriodic;
    options_.anisotropic = 16;
    options_.interpmode = settings.interpolation;
  }
  ~Peer() { OIIO::TextureSystem::destroy(system_); }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  float sample(const texmap::Footprint& f) {
    float color[3];
    // Its t runs down.
    system_->texture(handle_, thread_, options_, static_cast<float>(f.uv.x), static_cast<float>(1 - f.uv.y),
                     static_cast<float>(f.dx.x), static_cast<float>(-f.dx.y), static_cast<float>(f.dy.x),
                     static_cast<float>(-f.dy.y), 3, color);
    return color[0];
  }

 private:
  OIIO::TextureSystem* system_ = OIIO::TextureSystem::create(false);
  OIIO::TextureSystem::TextureHandle* handle_ = nullptr;
  OIIO::TextureSystem::Perthread* thread_ = nullptr;
  OIIO::TextureOpt options_;
};

glm::vec3 sample_cut(const texmap::TextureSampler& sampler, const texmap::Footprint& footprint, int most,
                     texmap::FilterThread& thread) {
  std::array<texmap::FootprintPart, 8> parts;
  const int count = texmap::cut_along_major(footprint, most, parts);
  glm::vec3 sum(0.0f);
  for (int i = 0; i < count; ++i) {
    const texmap::FootprintPart& part = parts[static_cast<std::size_t>(i)];
    sum += static_cast<float>(part.weight) * sampler.sample(part.footprint, thread);
  }
  return sum;
}

double psnr_of(const std::vector<double>& values, const std::vector<double>& reference) {
  double squares = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    squares += (values[i] - reference[i]) * (values[i] - reference[i]);
  return -10 * std::log10(squares / static_cast<double>(values.size()));
}

void write_picture(const std::filesystem::path& file, const std::vector<Pixel>& pixels,
                   const std::vector<double>& values) {
  texmap::Image image = texmap::make_float_image(kPicture, kPicture);
  auto& texels = std::get<std::vector<float>>(image.texels);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      texels[3 * static_cast<std::size_t>(pixels[i].y * kPicture + pixels[i].x) + k] =
          static_cast<float>(values[i]);
  }
  const std::vector<std::byte> bytes = texmap::encode_image(image, texmap::ImageFormat::kPng);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

// One method in one column.
struct Score {
  double psnr;
  double time;  // in units that all of a column share
};

// What is claimed, against every way of asking the peer: one of ours reaches its PSNR in at most half its
// time, and one of ours is at least 3 dB better at no more than its time. Prints a line a peer.
bool claims_hold(const std::string& column, const std::vector<Method>& methods,
                 const std::vector<Score>& scores) {
  bool all_hold = true;
  for (std::size_t p = 0; p < methods.size(); ++p) {
    if (!methods[p].is_peer()) continue;
    std::size_t fastest = methods.size();  // of ours that reach its PSNR
    std::size_t best = methods.size();     // of ours within its time
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (methods[m].is_peer()) continue;
      if (scores[m].psnr >= scores[p].psnr &&
          (fastest == methods.size() || scores[m].time < scores[fastest].time))
        fastest = m;
      if (scores[m].time <= scores[p].time && (best == methods.size() || scores[m].psnr > scores[best].psnr))
        best = m;
    }
    const double share = fastest < methods.size() ? scores[fastest].time / scores[p].time : HUGE_VAL;
    const double gain = best < methods.size() ? scores[best].psnr - scores[p].psnr : -HUGE_VAL;
    const bool holds = share <= 0.5 && gain >= 3;
    all_hold = all_hold && holds;
    std::printf("# %s, against %s: its PSNR by %s in %.0f %% of its time; %s is %+.1f dB within its time%s\n",
                column.c_str(), methods[p].name.c_str(),
                fastest < methods.size() ? methods[fastest].name.c_str() : "none", 100 * share,
                best < methods.size() ? methods[best].name.c_str() : "none", gain,
                holds ? "" : ": NOT AS CLAIMED (50 %, 3 dB)");
  }
  return all_hold;
}

}  // namespace

int main(int argc, char** argv) {
  bool is_box = false;
  std::filesystem::path pictures;
  std::filesystem::path csv_file;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--box") {
      is_box = true;
    } else if (argument == "--pictures" && i + 1 < argc) {
      pictures = argv[++i];
    } else {
      csv_file = argument;
    }
  }
  try {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("sweepkit_plane_filters_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    if (!pictures.empty()) std::filesystem::create_directories(pictures);
    using texmap::Filter;
    using Options = OIIO::TextureOpt;
    std::vector<Method> methods = {
        {"openimageio-smart-bicubic", PeerSettings{OIIO::TypeDesc::FLOAT, Options::InterpSmartBicubic}},
        {"openimageio-smart-bicubic-16-bit",
         PeerSettings{OIIO::TypeDesc::UINT16, Options::InterpSmartBicubic}},
        {"openimageio-bilinear", PeerSettings{OIIO::TypeDesc::FLOAT, Options::InterpBilinear}},
        {"openimageio-bicubic", PeerSettings{OIIO::TypeDesc::FLOAT, Options::InterpBicubic}}};
    for (std::size_t i = 0; i < texmap::kFilterNames.size(); ++i)
      methods.push_back({std::string(texmap::kFilterNames[i]), static_cast<Filter>(i)});
    for (const Filter filter : {Filter::kTrilinear, Filter::kIntegral1}) {
      for (const int parts : {4, 8}) {
        methods.push_back(
            {std::string(texmap::filter_name(filter)) + "-cut-" + std::to_string(parts), filter, parts});
      }
    }
    std::string csv = "texture,method,psnr_db,nanoseconds_median,nanoseconds_min,nanoseconds_max\n";
    bool all_hold = true;
    for (const Column& column : {Column{"checker 0", 0, checker()}, Column{"checker 35", 35, checker()},
                                 Column{"noise 35", 35, noise()}}) {
      const View view(column.turn_deg);
      const texmap::ImageTexture texture{to_image(column.texels)};
      const std::vector<Pixel> pixels = pixels_of(view);
      std::vector<double> reference;
      reference.reserve(pixels.size());
      for (const Pixel& pixel : pixels) reference.push_back(reference_at(view, column.texels, pixel, is_box));

      texmap::TileCache cache;
      texmap::FilterThread thread(cache);
      std::vector<std::unique_ptr<texmap::TextureSampler>> samplers;
      std::vector<std::unique_ptr<Peer>> peers;
      std::vector<std::vector<double>> values(methods.size(), std::vector<double>(pixels.size()));
      std::vector<bench::Contender> contenders;
      for (std::size_t m = 0; m < methods.size(); ++m) {
        std::vector<double>& out = values[m];
        std::function<void()> run;
        if (const auto* settings = std::get_if<PeerSettings>(&methods[m].lookup)) {
          peers.push_back(std::make_unique<Peer>(column.texels, *settings,
                                                 folder / (column.name + " " + methods[m].name + ".tx")));
          run = [&pixels, &out, peer = peers.back().get()] {
            for (std::size_t i = 0; i < pixels.size(); ++i)
              out[i] = static_cast<double>(peer->sample(pixels[i].footprint));
          };
        } else {
          samplers.push_back(std::make_unique<texmap::TextureSampler>(
              texture, std::get<Filter>(methods[m].lookup), cache, static_cast<std::uint32_t>(m)));
          run = [&pixels, &out, &thread, sampler = samplers.back().get(), most = methods[m].most_parts] {
            for (std::size_t i = 0; i < pixels.size(); ++i) {
              out[i] = most > 1
                           ? static_cast<double>(sample_cut(*sampler, pixels[i].footprint, most, thread).r)
                           : static_cast<double>(sampler->sample(pixels[i].footprint, thread).r);
            }
          };
        }
        contenders.push_back({.name = methods[m].name, .run = std::move(run), .check = [&out, &reference] {
                                return psnr_of(out, reference) > 10 ? "" : "the picture is another one";
                              }});
      }
      const bench::Comparison comparison = bench::compare(column.name, contenders, 7);
      std::vector<Score> scores;
      for (std::size_t m = 0; m < methods.size(); ++m) {
        const bench::Spread& seconds = comparison.results[m].seconds;
        const double each = 1e9 / static_cast<double>(pixels.size());
        // Ratios to the first contender in the same round are steadier than times.
        scores.push_back({psnr_of(values[m], reference), comparison.results[m].ratio.median});
        char line[200];
        std::snprintf(line, sizeof line, "%s,%s,%.2f,%.0f,%.0f,%.0f\n", column.name.c_str(),
                      methods[m].name.c_str(), scores[m].psnr, each * seconds.median, each * seconds.min,
                      each * seconds.max);
        csv += line;
        std::fputs(line, stdout);
        std::fflush(stdout);
        if (!pictures.empty())
          write_picture(pictures / (column.name + " " + methods[m].name + ".png"), pixels, values[m]);
      }
      if (!pictures.empty()) write_picture(pictures / (column.name + " reference.png"), pixels, reference);
      if (!is_box) all_hold = claims_hold(column.name, methods, scores) && all_hold;
    }
    if (!csv_file.empty()) std::ofstream(csv_file) << csv;
    std::filesystem::remove_all(folder);
    if (!all_hold) return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "plane_filters: %s\n", error.what());
    return 1;
  }
}
