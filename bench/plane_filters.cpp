// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Error against time of every filter, and of OpenImageIO's texture system beside them, on a plane that runs
// to the horizon: a texture of 1,024 texels a side that repeats, a picture of 512 pixels a side, the exact
// footprint of each pixel known. A checker along the plane's axes, the same turned by 35 degrees, and noise
// of equal strength in every octave, turned too. The reference takes 64 x 64 samples of the texture a pixel
// under a tent of one pixel each way (--box: under a box of one pixel). One thread.
//
// Usage: plane_filters [--box] [--pictures FOLDER] [FILE.csv]

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <string>
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
struct View {
  double turn_deg;

  std::optional<glm::dvec2> uv(glm::dvec2 pixel) const {
    const double pitch = -20 * std::numbers::pi / 180;
    const double half = std::tan(30 * std::numbers::pi / 180);
    const double x = (2 * pixel.x / kPicture - 1) * half;
    const double y = (1 - 2 * pixel.y / kPicture) * half;
    const double fall = -(y * std::cos(pitch) + std::sin(pitch));
    const double ahead = std::cos(pitch) - y * std::sin(pitch);
    if (fall < ahead * std::tan(1 * std::numbers::pi / 180)) return std::nullopt;
    const double turn = turn_deg * std::numbers::pi / 180;
    const glm::dvec2 at = glm::dvec2(x, ahead) / fall;
    return 0.5 * glm::dvec2(std::cos(turn) * at.x - std::sin(turn) * at.y,
                            std::sin(turn) * at.x + std::cos(turn) * at.y);
  }
};

using Texels = std::vector<float>;  // grey

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
    std::vector<double> lattice;
    for (int i = 0; i < cells * cells; ++i)
      lattice.push_back(std::uniform_real_distribution<>(-1, 1)(random));
    const auto at = [&](int x, int y) {
      return lattice[static_cast<std::size_t>((y % cells) * cells + x % cells)];
    };
    for (int y = 0; y < kTexture; ++y) {
      for (int x = 0; x < kTexture; ++x) {
        const double gx = (x + 0.5) * cells / kTexture;
        const double gy = (y + 0.5) * cells / kTexture;
        const int ix = static_cast<int>(gx);
        const int iy = static_cast<int>(gy);
        const double fx = gx - ix;
        const double fy = gy - iy;
        sum[static_cast<std::size_t>(y * kTexture + x)] += std::lerp(
            std::lerp(at(ix, iy), at(ix + 1, iy), fx), std::lerp(at(ix, iy + 1), at(ix + 1, iy + 1), fx), fy);
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

double reference_at(const View& view, const texmap::Texture& texture, const Pixel& pixel, bool is_box) {
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
      sum += weight * texmap::point_sample(texture, uv, glm::dvec3(0.0)).r;
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

struct Method {
  std::string name;
  std::optional<texmap::Filter> filter;  // none: OpenImageIO
  int anisotropy = 0;
};

struct Peer {
  OIIO::TextureSystem* system = OIIO::TextureSystem::create(false);
  OIIO::TextureSystem::TextureHandle* handle = nullptr;
  OIIO::TextureSystem::Perthread* thread = nullptr;

  Peer(const Texels& texels, const std::filesystem::path& file) {
    const OIIO::ImageSpec spec(kTexture, kTexture, 3, OIIO::TypeDesc::UINT16);
    OIIO::ImageBuf image(spec);
    for (int y = 0; y < kTexture; ++y) {
      for (int x = 0; x < kTexture; ++x) {
        const float value = texels[static_cast<std::size_t>(y * kTexture + x)];
        image.setpixel(x, y, OIIO::cspan<float>({value, value, value}));
      }
    }
    OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, image, file.string(), {});
    handle = system->get_texture_handle(OIIO::ustring(file.string()));
    thread = system->get_perthread_info();
  }
  ~Peer() { OIIO::TextureSystem::destroy(system); }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  float sample(const texmap::Footprint& f, int anisotropy) const {
    OIIO::TextureOpt options;
    options.swrap = options.twrap = OIIO::TextureOpt::WrapPeriodic;
    options.anisotropic = anisotropy;
    float color[3];
    // Its t runs down.
    system->texture(handle, thread, options, static_cast<float>(f.uv.x), static_cast<float>(1 - f.uv.y),
                    static_cast<float>(f.dx.x), static_cast<float>(-f.dx.y), static_cast<float>(f.dy.x),
                    static_cast<float>(-f.dy.y), 3, color);
    return color[0];
  }
};

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
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "sweepkit_plane_filters";
    std::filesystem::create_directories(folder);
    if (!pictures.empty()) std::filesystem::create_directories(pictures);
    using texmap::Filter;
    const std::vector<Method> methods = {{"point", Filter::kPoint},
                                         {"bilinear", Filter::kBilinear},
                                         {"trilinear", Filter::kTrilinear},
                                         {"integral-1", Filter::kIntegral1},
                                         {"integral-2", Filter::kIntegral2},
                                         {"integral-3", Filter::kIntegral3},
                                         {"ewa", Filter::kEwa},
                                         {"auto", Filter::kAuto},
                                         {"openimageio-16", std::nullopt, 16},
                                         {"openimageio-64", std::nullopt, 64}};
    std::string csv = "texture,method,psnr_db,nanoseconds_median,nanoseconds_min,nanoseconds_max\n";
    for (const Column& column : {Column{"checker 0", 0, checker()}, Column{"checker 35", 35, checker()},
                                 Column{"noise 35", 35, noise()}}) {
      const View view{column.turn_deg};
      const texmap::ImageTexture texture{to_image(column.texels)};
      const std::vector<Pixel> pixels = pixels_of(view);
      std::vector<double> reference;
      for (const Pixel& pixel : pixels) reference.push_back(reference_at(view, texture, pixel, is_box));
      const Peer peer(
          column.texels,
          folder / (std::string(1, static_cast<char>('a' + static_cast<int>(column.turn_deg) % 26)) +
                    column.name.substr(0, 1) + ".tx"));

      texmap::TileCache cache;
      texmap::FilterThread thread(cache);
      std::vector<std::unique_ptr<texmap::TextureSampler>> samplers;
      std::vector<std::vector<double>> values(methods.size(), std::vector<double>(pixels.size()));
      std::vector<bench::Contender> contenders;
      for (std::size_t m = 0; m < methods.size(); ++m) {
        const Method& method = methods[m];
        if (method.filter)
          samplers.push_back(std::make_unique<texmap::TextureSampler>(texture, *method.filter, cache,
                                                                      static_cast<std::uint32_t>(m)));
        const texmap::TextureSampler* sampler = method.filter ? samplers.back().get() : nullptr;
        std::vector<double>& out = values[m];
        contenders.push_back({.name = method.name,
                              .run =
                                  [&pixels, &thread, &peer, &out, sampler, anisotropy = method.anisotropy] {
                                    for (std::size_t i = 0; i < pixels.size(); ++i) {
                                      const texmap::Footprint& f = pixels[i].footprint;
                                      out[i] = sampler != nullptr
                                                   ? static_cast<double>(sampler->sample(f, thread).r)
                                                   : static_cast<double>(peer.sample(f, anisotropy));
                                    }
                                  },
                              .check =
                                  [&out, &reference] {
                                    return psnr_of(out, reference) > 10 ? "" : "the picture is another one";
                                  }});
      }
      const bench::Comparison comparison = bench::compare(column.name, contenders, 5);
      for (std::size_t m = 0; m < methods.size(); ++m) {
        const bench::Spread& seconds = comparison.results[m].seconds;
        const double each = 1e9 / static_cast<double>(pixels.size());
        char line[200];
        std::snprintf(line, sizeof line, "%s,%s,%.2f,%.0f,%.0f,%.0f\n", column.name.c_str(),
                      methods[m].name.c_str(), psnr_of(values[m], reference), each * seconds.median,
                      each * seconds.min, each * seconds.max);
        csv += line;
        std::fputs(line, stdout);
        if (!pictures.empty())
          write_picture(pictures / (column.name + " " + methods[m].name + ".png"), pixels, values[m]);
      }
      if (!pictures.empty()) write_picture(pictures / (column.name + " reference.png"), pixels, reference);
    }
    if (!csv_file.empty()) std::ofstream(csv_file) << csv;
    std::filesystem::remove_all(folder);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "plane_filters: %s\n", error.what());
    return 1;
  }
}
