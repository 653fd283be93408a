// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The only file of libtexmap that knows OpenImageIO. It is a module of its own, loaded when an image is first
// read or written: linking OpenImageIO brings in 261 shared libraries and costs 0.3 s at every start of a
// program.

#include "image_module.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <system_error>

namespace sweepkit::texmap {
namespace {

// Far above any texture in use, far below what a broken header can ask for.
constexpr std::int64_t kMostTexels = std::int64_t{1} << 31;

std::string last_error() {
  std::string text = OIIO::geterror();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.empty() ? "not an image that can be read" : text;
}

// geterror() forgets what it has told once; an empty text would read as success here.
template <class File>
std::string error_of(const File& file, const char* otherwise) {
  std::string text = file.geterror();
  return text.empty() ? otherwise : text;
}

std::string problem_of(const std::exception& error) {
  // A thread that cannot be made lacks the memory of its stack.
  const auto* failed = dynamic_cast<const std::system_error*>(&error);
  const bool is_memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
                         (failed != nullptr && failed->code() == std::errc::resource_unavailable_try_again);
  return is_memory ? kOutOfMemory : error.what();
}

std::string size_text(const OIIO::ImageSpec& spec) {
  return std::to_string(spec.width) + " x " + std::to_string(spec.height);
}

// Once: its pool of threads aborts the program when two threads change its size at the same time.
void keep_to_this_thread() {
  [[maybe_unused]] static const bool is_kept = OIIO::attribute("threads", 1);
}

std::unique_ptr<OIIO::ImageInput> open_input(const std::string& file, std::string& problem) {
  keep_to_this_thread();
  // Colours as the file has them: OpenImageIO would multiply them by alpha, in sRGB and in 8 bits.
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(file, &config);
  if (!input) {
    problem = last_error();
    return nullptr;
  }
  const OIIO::ImageSpec& spec = input->spec();
  const std::int64_t texels = static_cast<std::int64_t>(spec.width) * spec.height;
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) {
    problem = "the image has no pixels";
  } else if (spec.depth > 1) {
    problem = "the image is a volume, not a picture";
  } else if (texels > kMostTexels || texels * spec.nchannels > 2 * kMostTexels) {
    problem = "the image has " + size_text(spec) + " pixels of " + std::to_string(spec.nchannels) +
              " channels; at most 2^31 pixels and 2^32 numbers can be read";
  }
  if (!problem.empty()) input.reset();
  return input;
}

// libpng and libjpeg print what they find wrong to standard error, and OpenImageIO 2.4 lets them. A library
// does not print: while one of these lives, standard error goes nowhere. What they found comes back as the
// message.
class QuietErrors {
 public:
  QuietErrors() : lock_(one_at_a_time()), saved_(::dup(STDERR_FILENO)) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (saved_ >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) ::close(nowhere);
  }
  ~QuietErrors() {
    if (saved_ < 0) return;
    ::dup2(saved_, STDERR_FILENO);
    ::close(saved_);
  }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  static std::mutex& one_at_a_time() {
    static std::mutex mutex;
    return mutex;
  }
  std::lock_guard<std::mutex> lock_;
  int saved_;
};

bool is_integer(const OIIO::TypeDesc& type) {
  return type.basetype == OIIO::TypeDesc::UINT8 || type.basetype == OIIO::TypeDesc::UINT16;
}

// The first `channels` of the whole image in bands of rows, each handed on as it comes: a header that
// promises more than the file holds fails at the first band, before the memory for the rest is touched.
template <class Sample, class Take>
std::string read_bands(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int channels, Take&& take) {
  const OIIO::TypeDesc type = OIIO::BaseTypeFromC<Sample>::value;
  const bool is_tiled = spec.tile_width > 0;
  const int band = is_tiled ? spec.tile_height : 64;
  std::vector<Sample> samples;
  for (int y = 0; y < spec.height;) {
    const int end = std::min(spec.height - y, band) + y;
    samples.resize(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(channels) *
                   static_cast<std::size_t>(end - y));
    const bool is_read =
        is_tiled
            ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + y, spec.y + end, spec.z,
                               spec.z + 1, 0, channels, type, samples.data())
            : input.read_scanlines(0, 0, spec.y + y, spec.y + end, spec.z, 0, channels, type, samples.data());
    if (!is_read) return error_of(input, "its pixels cannot be read");
    if (std::string problem = take(y, end - y, samples); !problem.empty()) return problem;
    y = end;
  }
  // A JPEG that ends early is filled up with grey and counted as read; what the decoder complained of is
  // kept.
  return input.geterror();
}

int channels_of(const OIIO::ImageSpec& spec) {
  return std::min(spec.nchannels, 4);
}

std::string read(const std::string& file, ModuleImage& image) try {
  const QuietErrors quiet;
  std::string problem;
  const auto input = open_input(file, problem);
  if (!input) return problem;
  const OIIO::ImageSpec spec = input->spec();
  image.width = spec.width;
  image.height = spec.height;
  image.channels = channels_of(spec);
  const auto read_into = [&](auto& whole) {
    using Sample = typename std::remove_reference_t<decltype(whole)>::value_type;
    whole.reserve(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                  static_cast<std::size_t>(image.channels));
    return read_bands<Sample>(*input, spec, image.channels, [&](int, int, const std::vector<Sample>& band) {
      whole.insert(whole.end(), band.begin(), band.end());
      return std::string();
    });
  };
  try {
    return is_integer(spec.format) ? read_into(image.samples.emplace<std::vector<std::uint16_t>>())
                                   : read_into(image.samples.emplace<std::vector<float>>());
  } catch (const std::bad_alloc&) {
    return "its " + size_text(spec) + " pixels are more than the memory holds";
  }
} catch (const std::exception& error) {
  return problem_of(error);
}

std::string read_rows(const std::string& file, TakeRows take, void* context) try {
  const QuietErrors quiet;
  std::string problem;
  const auto input = open_input(file, problem);
  if (!input) return problem;
  const OIIO::ImageSpec spec = input->spec();
  const auto hand_on = [&](int first, int count, const auto& band) {
    return take(context, first, count, band.data());
  };
  return is_integer(spec.format) ? read_bands<std::uint16_t>(*input, spec, channels_of(spec), hand_on)
                                 : read_bands<float>(*input, spec, channels_of(spec), hand_on);
} catch (const std::exception& error) {
  return problem_of(error);
}

// A file behind a cache of its own tiles.
struct TiledFile {
  OIIO::ustring name;
  OIIO::ImageCache* cache = nullptr;
  int x = 0;  // of the image's first texel
  int y = 0;
  int channels = 0;
  OIIO::TypeDesc type;

  TiledFile() = default;
  TiledFile(const TiledFile&) = delete;
  TiledFile& operator=(const TiledFile&) = delete;
  ~TiledFile() {
    if (cache != nullptr) OIIO::ImageCache::destroy(cache);
  }
};

std::string open(const std::string& file, std::size_t cache_bytes, ModuleFile& opened) try {
  const QuietErrors quiet;
  std::string problem;
  const auto input = open_input(file, problem);
  if (!input) return problem;
  const OIIO::ImageSpec spec = input->spec();
  auto tiled = std::make_unique<TiledFile>();
  tiled->name = file;
  tiled->cache = OIIO::ImageCache::create(false);
  tiled->cache->attribute("max_memory_MB", static_cast<float>(cache_bytes) / (1 << 20));
  tiled->cache->attribute("unassociatedalpha", 1);
  tiled->cache->attribute("accept_untiled", 1);
  tiled->x = spec.x;
  tiled->y = spec.y;
  tiled->channels = channels_of(spec);
  // As the file has them: OpenImageIO goes by way of float from one integer to another, and takes longer for
  // that than for the decoding.
  tiled->type = is_integer(spec.format) ? spec.format : OIIO::TypeDesc(OIIO::TypeDesc::FLOAT);
  opened = {
      tiled.get(),        spec.width, spec.height, tiled->channels, static_cast<int>(tiled->type.size()),
      spec.tile_width > 0};
  static_cast<void>(tiled.release());
  return {};
} catch (const std::exception& error) {
  return problem_of(error);
}

std::string read_rect(void* handle, const ModuleRect& rect, void* samples) try {
  const auto& file = *static_cast<const TiledFile*>(handle);
  const int x = file.x + rect.x;
  const int y = file.y + rect.y;
  const bool is_read = file.cache->get_pixels(file.name, 0, 0, x, x + rect.width, y, y + rect.height, 0, 1, 0,
                                              file.channels, file.type, samples);
  return is_read ? std::string() : error_of(*file.cache, "its pixels cannot be read");
} catch (const std::exception& error) {
  return problem_of(error);
}

void close(void* handle) {
  delete static_cast<TiledFile*>(handle);
}

std::string read_info(const std::string& file, ModuleInfo& info) try {
  const QuietErrors quiet;
  std::string problem;
  const auto input = open_input(file, problem);
  if (!input) return problem;
  const OIIO::ImageSpec& spec = input->spec();
  info = {spec.width,          spec.height,
          spec.nchannels,      input->format_name(),
          spec.format.c_str(), std::string(spec.get_string_attribute("ImageDescription"))};
  return {};
} catch (const std::exception& error) {
  return problem_of(error);
}

// By ImageFormat.
constexpr const char* kExtensions[] = {"png", "jpg", "tif", "exr"};
constexpr const char* kFormatNames[] = {"png", "jpeg", "tiff", "openexr"};

OIIO::ImageSpec spec_of(const FileImage& image) {
  const bool is_exr = image.format == ImageFormat::kExr;
  const bool is_tiff = image.format == ImageFormat::kTiff;
  const auto type_of = [&](int bits) -> OIIO::TypeDesc {
    if (is_exr) return bits == 16 ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
    return bits == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8;
  };
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                       type_of(image.channels.empty() ? 8 : image.channels.front().bits));
  bool is_mixed = false;
  for (std::size_t k = 0; k < image.channels.size(); ++k) {
    spec.channelnames[k] = image.channels[k].name;
    if (image.channels[k].name == "A") spec.alpha_channel = static_cast<int>(k);
    is_mixed |= image.channels[k].bits != image.channels.front().bits;
  }
  if (is_mixed) {
    for (const FileChannel& channel : image.channels) spec.channelformats.push_back(type_of(channel.bits));
  }
  // Colours are not multiplied by alpha, and are not to be divided by it.
  if (spec.alpha_channel >= 0 && !is_exr) spec.attribute("oiio:UnassociatedAlpha", 1);
  if (is_exr && image.window.full_width > 0) {
    spec.x = image.window.x;
    spec.y = image.window.y;
    spec.full_width = image.window.full_width;
    spec.full_height = image.window.full_height;
  }
  // The time of writing would make two runs differ.
  spec.attribute("DateTime", "2000:01:01 00:00:00");
  spec.attribute("Software", "sweepkit");
  if (!image.description.empty()) spec.attribute("ImageDescription", image.description);
  // In a TIFF this would become an Exif directory, which OpenImageIO 2.4 writes over the first one when in
  // memory.
  if (!is_tiff) spec.attribute("oiio:ColorSpace", image.is_srgb ? "sRGB" : "Linear");
  if (image.format == ImageFormat::kJpeg) {
    spec.attribute("Compression", "jpeg:95");
    spec.attribute("jpeg:subsampling", "4:4:4");
  } else if (is_exr || is_tiff) {
    spec.attribute("compression", "zip");
  }
  return spec;
}

std::string encode(const FileImage& image, std::vector<std::byte>& bytes) try {
  keep_to_this_thread();
  const std::string extension = kExtensions[static_cast<std::size_t>(image.format)];
  std::vector<unsigned char> buffer;
  OIIO::Filesystem::IOVecOutput memory(buffer);
  const std::string name = "picture." + extension;
  const auto output = OIIO::ImageOutput::create(name, &memory);
  if (!output) return last_error();
  if (!output->supports("ioproxy")) return "the " + extension + " encoder cannot write to memory";
  if (!output->open(name, spec_of(image))) return error_of(*output, "the encoder does not take the image");
  const bool is_written = std::visit(
      [&](const auto& samples) {
        using Sample = typename std::remove_reference_t<decltype(samples)>::value_type;
        return output->write_image(OIIO::BaseTypeFromC<Sample>::value, samples.data());
      },
      image.samples);
  if (!is_written || !output->close()) return error_of(*output, "the encoder fails");
  bytes.resize(buffer.size());
  std::memcpy(bytes.data(), buffer.data(), buffer.size());
  return {};
} catch (const std::exception& error) {
  return problem_of(error);
}

std::string read_file(const std::string& file, FileImage& image) try {
  constexpr int kMostChannels = 64;
  const QuietErrors quiet;
  std::string problem;
  const auto input = open_input(file, problem);
  if (!input) return problem;
  const OIIO::ImageSpec spec = input->spec();
  const auto* const format =
      std::find(std::begin(kFormatNames), std::end(kFormatNames), std::string_view(input->format_name()));
  if (format == std::end(kFormatNames)) return "it is no PNG, JPEG, TIFF or EXR file";
  if (spec.nchannels > kMostChannels) return "it has " + std::to_string(spec.nchannels) + " channels";
  image.width = spec.width;
  image.height = spec.height;
  image.format = static_cast<ImageFormat>(format - std::begin(kFormatNames));
  image.is_srgb = image.format != ImageFormat::kExr;
  image.description = spec.get_string_attribute("ImageDescription");
  if (spec.x != 0 || spec.y != 0 || spec.full_width != spec.width || spec.full_height != spec.height)
    image.window = {spec.x, spec.y, spec.full_width, spec.full_height};
  for (int k = 0; k < spec.nchannels; ++k) {
    image.channels.push_back({spec.channel_name(k), static_cast<int>(8 * spec.channelformat(k).size())});
  }
  const auto read_into = [&](auto& whole) {
    using Sample = typename std::remove_reference_t<decltype(whole)>::value_type;
    return read_bands<Sample>(*input, spec, spec.nchannels, [&](int, int, const std::vector<Sample>& band) {
      whole.insert(whole.end(), band.begin(), band.end());
      return std::string();
    });
  };
  if (spec.format == OIIO::TypeDesc::UINT8)
    return read_into(image.samples.emplace<std::vector<std::uint8_t>>());
  if (is_integer(spec.format)) return read_into(image.samples.emplace<std::vector<std::uint16_t>>());
  return read_into(image.samples.emplace<std::vector<float>>());
} catch (const std::exception& error) {
  return problem_of(error);
}

}  // namespace
}  // namespace sweepkit::texmap

// The name is kImageModuleSymbol.
extern "C" __attribute__((visibility("default")))
const sweepkit::texmap::ImageModule sweepkit_image_module_3 = {
    sweepkit::texmap::read,   sweepkit::texmap::read_info, sweepkit::texmap::read_rows,
    sweepkit::texmap::open,   sweepkit::texmap::read_rect, sweepkit::texmap::close,
    sweepkit::texmap::encode, sweepkit::texmap::read_file};
