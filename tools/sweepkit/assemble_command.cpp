// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The tiles' own numbers are put together, not their light: the file comes out as if the area had been drawn
// at once, bit for bit. Memory: the picture, one tile and the encoder's bytes.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>

#include "commands.hpp"
#include "output.hpp"
#include "picture_mark.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/output_file.hpp"
#include "sweepkit/texmap/file_image.hpp"

namespace sweepkit::tools {
namespace {

struct Assemble {
  std::vector<std::string> tiles;
  Output output;
};

struct TileFile {
  std::string file;
  PictureMark mark;
};

// Whole or not, tiles of the same area of the same picture have this in common.
std::string text_without_index(PictureMark mark) {
  mark.tile->index = 1;
  return to_text(mark);
}

TileFile read_mark(const std::string& file) {
  texmap::read_image_info(file);  // says what is wrong with a file that is no image
  std::optional<PictureMark> mark = parse_mark(texmap::read_description(file));
  if (!mark || !mark->tile) {
    throw InputError({.file = file}, "is no tile; draw it with sweepkit render --tile I/N");
  }
  return {file, *std::move(mark)};
}

// In order, all of one picture, none missing and none twice.
std::vector<TileFile> read_marks(const std::vector<std::string>& files) {
  std::vector<TileFile> tiles;
  tiles.reserve(files.size());
  for (const std::string& file : files) tiles.push_back(read_mark(file));
  const TileFile& first = tiles.front();
  for (const TileFile& tile : tiles) {
    if (text_without_index(tile.mark) == text_without_index(first.mark)) continue;
    const bool is_same_picture = tile.mark.key == first.mark.key && tile.mark.turn == first.mark.turn;
    throw InputError({.file = tile.file},
                     is_same_picture
                         ? "is cut otherwise than " + first.file + ": tile " +
                               std::to_string(tile.mark.tile->index) + "/" +
                               std::to_string(tile.mark.tile->count) + " beside " +
                               std::to_string(first.mark.tile->index) + "/" +
                               std::to_string(first.mark.tile->count) + ", or of another --size or --crop"
                         : "is of another picture than " + first.file +
                               ": the scene, its files, the options, the frame or the program differ; draw "
                               "both again");
  }
  std::ranges::stable_sort(tiles, {}, [](const TileFile& tile) { return tile.mark.tile->index; });
  const int count = tiles.front().mark.tile->count;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const int expected = static_cast<int>(i) + 1;
    const int index = tiles[i].mark.tile->index;
    if (index < expected) {
      throw InputError({.file = tiles[i].file},
                       "is tile " + std::to_string(index) + " again, as " + tiles[i - 1].file + " is");
    }
    if (index > expected) break;
    if (i + 1 == static_cast<std::size_t>(count)) return tiles;
  }
  std::vector<bool> is_there(static_cast<std::size_t>(count) + 1, false);
  for (const TileFile& tile : tiles) is_there[static_cast<std::size_t>(tile.mark.tile->index)] = true;
  const auto missing = std::find(is_there.begin() + 1, is_there.end(), false);
  throw InputError("tile " + std::to_string(missing - is_there.begin()) + " of " + std::to_string(count) +
                   " is missing (" + std::to_string(tiles.size()) + " are given); draw it with --tile " +
                   std::to_string(missing - is_there.begin()) + "/" + std::to_string(count));
}

texmap::FileImage read_tile(const TileFile& tile) {
  texmap::FileImage image = texmap::read_file_image(tile.file);
  const render::Region part = part_of(tile.mark.area, *tile.mark.tile);
  if (image.width != part.width || image.height != part.height) {
    throw InputError({.file = tile.file}, "has " + std::to_string(image.width) + " x " +
                                              std::to_string(image.height) + " pixels where its tile has " +
                                              std::to_string(part.width) + " x " +
                                              std::to_string(part.height) + "; draw it again");
  }
  return image;
}

texmap::FileImage put_together(const std::vector<TileFile>& tiles) {
  const PictureMark& mark = tiles.front().mark;
  texmap::FileImage whole = read_tile(tiles.front());
  const std::size_t numbers = static_cast<std::size_t>(mark.area.width) *
                              static_cast<std::size_t>(mark.area.height) * whole.channels.size();
  std::visit([&](auto& samples) { samples.reserve(numbers); }, whole.samples);
  for (std::size_t i = 1; i < tiles.size(); ++i) {
    const texmap::FileImage tile = read_tile(tiles[i]);
    if (tile.format != whole.format || tile.channels != whole.channels) {
      throw InputError({.file = tiles[i].file}, "has another format or other channels than " +
                                                    tiles.front().file + "; put files of one kind together");
    }
    std::visit(
        [&](auto& samples) {
          const auto& more = std::get<std::remove_reference_t<decltype(samples)>>(tile.samples);
          samples.insert(samples.end(), more.begin(), more.end());
        },
        whole.samples);
  }
  const bool is_crop = mark.area.width != mark.width || mark.area.height != mark.height;
  whole.width = mark.area.width;
  whole.height = mark.area.height;
  whole.window = is_crop ? texmap::ImageWindow{mark.area.x, mark.area.y, mark.width, mark.height}
                         : texmap::ImageWindow{};
  PictureMark of_whole = mark;
  of_whole.tile.reset();
  whole.description = mark.is_whole_marked ? to_text(of_whole) : std::string();
  return whole;
}

void assemble(const Assemble& command) {
  const auto start = std::chrono::steady_clock::now();
  const Output& output = command.output;
  const std::vector<TileFile> tiles = read_marks(command.tiles);
  // Without a name or --format the tiles tell.
  const bool names_format = !output.is_standard() || !output.format.empty();
  if (names_format) picture_format(output);
  scene::check_output(output.file);
  const texmap::FileImage whole = put_together(tiles);
  if (names_format && picture_format(output) != whole.format) {
    static constexpr const char* kExtensions[] = {".png", ".jpg", ".tif", ".exr"};
    throw InputError({.file = output.file}, std::string("the tiles are ") +
                                                kExtensions[static_cast<std::size_t>(whole.format)] +
                                                " files, and so is what they are put together to");
  }
  const std::vector<std::byte> bytes = encode_file(whole);
  scene::write_files(std::vector<scene::OutputFile>{{output.file, bytes}});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say((output.is_standard() ? "standard output" : output.file) + ": " + std::to_string(whole.width) + " x " +
          std::to_string(whole.height) + " pixels of " + std::to_string(tiles.size()) +
          (tiles.size() == 1 ? " tile in " : " tiles in ") + duration_text(seconds),
      output);
}

}  // namespace

void add_assemble(CLI::App& app) {
  const auto command = std::make_shared<Assemble>();
  CLI::App& sub = *app.add_subcommand("assemble", "Put the tiles of a picture together");
  sub.add_option("TILES", command->tiles, "Files that render --tile I/N wrote, in any order")
      ->required()
      ->type_name("");
  add_picture_output(sub, command->output, "The picture, of the tiles' own format");
  sub.get_option("-o")->required();
  add_quiet(sub, command->output);
  sub.footer(
      "The file is the one that render writes without --tile, bit for bit.\n\n"
      "Examples:\n"
      "  sweepkit render samples/scenes/rope.json --tile 1/2 -o part_1.png\n"
      "  sweepkit render samples/scenes/rope.json --tile 2/2 -o part_2.png\n"
      "  sweepkit assemble part_1.png part_2.png -o rope.png");
  sub.callback([command] { assemble(*command); });
}

}  // namespace sweepkit::tools
