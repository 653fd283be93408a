// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <initializer_list>
#include <memory>

#include "commands.hpp"
#include "findings.hpp"
#include "generate.hpp"
#include "memory.hpp"
#include "plan_table.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/gltf_size.hpp"
#include "sweepkit/scene/gltf_source.hpp"
#include "sweepkit/scene/levels.hpp"
#include "sweepkit/scene/mesh_file.hpp"
#include "sweepkit/scene/mesh_output.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/output_file.hpp"
#include "texel_density_option.hpp"

namespace sweepkit::tools {
namespace {

constexpr double kLeastSeconds = 0.01;
constexpr double kMostSeconds = 86400;
constexpr int kMostTexels = 16384;  // a side: kMostPixels in all

void write(const std::vector<scene::NamedBytes>& parts, const std::filesystem::path& file) {
  std::vector<scene::OutputFile> files;
  for (const scene::NamedBytes& part : parts) {
    const bool is_whole = &part == &parts.back();
    files.push_back({is_whole ? file : file.parent_path() / part.name, part.bytes});
  }
  scene::write_files(files);
}

void write(const scene::GltfPieces& gltf, const std::filesystem::path& file) {
  std::vector<scene::OutputFile> files;
  for (const scene::GltfPieces::File& part : gltf.files) {
    const bool is_whole = &part == &gltf.files.back();
    files.push_back({is_whole ? file : file.parent_path() / part.name, {}, part.pieces});
  }
  scene::write_files(files);
}

// What the meshes and the file take together, of what the meshes take: the bytes of a triangle with its half
// a vertex are 30 in memory, about as many in glTF and PLY, 50 in STL, and up to 80 and 120 as text.
std::uint64_t memory_factor(const std::string& file) {
  if (!scene::is_mesh_name(file)) return 2;
  switch (scene::mesh_format(file)) {
    case scene::MeshFormat::kPly:
      return 3;  // with the positions in the world
    case scene::MeshFormat::kStl:
      return 4;
    default:
      return 6;
  }
}

void generate_one(const Generate& command) {
  const auto start = std::chrono::steady_clock::now();
  const Output& output = command.output;
  if (!output.file.empty()) {
    check_model_name(output.file);
    scene::check_output(output.file);
  }
  const scene::SceneFile scene = open_scene(command.input);
  scene::Document document = scene.document();
  if (!command.object.empty()) keep_object(document, command.object);
  const scene::Plan plan = scene::plan(document, model_request(output.file, command.gltf));
  if (output.file.empty()) {
    print({{}, {plan_table(plan, {})}}, output);
    return;
  }
  // The file is put together in memory beside the meshes, and again as it is written.
  const scene::MemoryEstimate needed = scene::estimate_memory(document);
  if (!scene::is_mesh_name(output.file)) scene::check_gltf_size(document, command.gltf);
  const std::uint64_t factor = memory_factor(output.file);
  require_memory(command.input.name(), needed, factor * needed.bytes);
  limit_triangles(document, factor * scene::kLeastBytesATriangle);
  scene::GltfOptions options = command.gltf;
  options.threads = command.threads;
  if (keeps_scene(command, output.file)) options.scene = scene.text();
  const MadeFile made = make_file(document, plan, output.file, options, !output.is_quiet);
  warn(made.findings, output);
  if (output.explains) print({{}, {plan_table(plan, made.ledger)}}, output);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say((output.is_standard() ? "standard output" : output.file) + ": " + std::to_string(made.objects) +
          (made.objects == 1 ? " object, " : " objects, ") +
          (made.instances > made.objects ? std::to_string(made.instances) + " instances, " : "") +
          std::to_string(made.triangles) + " triangles" +
          (made.triangles_without_area > 0 ? " (" + std::to_string(made.triangles_without_area) +
                                                 " without area when quantized are left out)"
                                           : "") +
          (made.coarser_triangles > 0
               ? " (and " + std::to_string(made.coarser_triangles) + " of coarser levels)"
               : "") +
          (made.targets > 0
               ? " (growing: within " + length_text(made.grow_error) + " by " + std::to_string(made.targets) +
                     (made.targets == 1 ? " morph target)" : " morph targets)")
               : "") +
          (made.deviation ? " (by tolerance: within " + length_text(*made.deviation) + ")" : "") + ", " +
          std::to_string(made.bytes) + " bytes in " + duration_text(seconds),
      output);
}

// Options of glTF alone, and what other formats lack.
constexpr std::array<std::array<const char*, 2>, 15> kGltfOptions = {{
    {"--no-extras", ""},
    {"--copyright", "copyright"},
    {"--tangents", "tangents"},
    {"--unlit", "materials without light"},
    {"--compatible", "extensions to do without"},
    {"--images", ""},
    {"--image-format", ""},
    {"--max-texture", ""},
    {"--quantize", "quantized vertices"},
    {"--position-bits", "quantized vertices"},
    {"--meshopt", "packed vertices"},
    {"--minimal", ""},
    {"--lod", "levels of detail"},
    {"--turntable", "animation"},
    {"--grow", "animation"},
}};

// A glTF made again from itself has its own options where no others are given.
void take_options_of(const scene::GltfOptions& own, Generate& command) {
  scene::GltfOptions& gltf = command.gltf;
  const auto take = [&](std::initializer_list<const char*> options, auto& mine, const auto& theirs) {
    const auto is_given = [&](const char* option) { return command.options->count(option) > 0; };
    if (std::none_of(options.begin(), options.end(), is_given)) mine = theirs;
  };
  take({"--object"}, command.object, own.object.value_or(""));
  take({"--bake-size", "--texel-density"}, gltf.bake_size, own.bake_size);
  take({"--bake-size", "--texel-density"}, gltf.texel_density, own.texel_density);
  take({"--tangents"}, gltf.has_tangents, own.has_tangents);
  take({"--unlit", "--compatible"}, gltf.look, own.look);
  take({"--images"}, gltf.images_in, own.images_in);
  take({"--image-format"}, gltf.image_format, own.image_format);
  take({"--max-texture"}, gltf.max_texture, own.max_texture);
  take({"--lod"}, gltf.levels, own.levels);
  take({"--turntable"}, gltf.turntable_seconds, own.turntable_seconds);
  take({"--grow"}, gltf.grow_seconds, own.grow_seconds);
  take({"--copyright"}, gltf.copyright, own.copyright);
  take({"--quantize"}, gltf.is_quantized, own.is_quantized);
  take({"--position-bits"}, gltf.position_bits, own.position_bits);
  take({"--meshopt"}, gltf.is_packed, own.is_packed);
}

void settle_gltf_options(Generate& command) {
  scene::GltfOptions& gltf = command.gltf;
  if (command.is_unlit) gltf.look = scene::GltfLook::kUnlit;
  if (command.is_compatible) gltf.look = scene::GltfLook::kCompatible;
  if (command.images == "embedded") gltf.images_in = scene::GltfImages::kEmbedded;
  if (command.images == "separate") gltf.images_in = scene::GltfImages::kSeparate;
  if (command.image_format == "png") gltf.image_format = texmap::ImageFormat::kPng;
  if (command.image_format == "jpg") gltf.image_format = texmap::ImageFormat::kJpeg;
  if (scene::is_gltf_name(command.input.file) && !scene::is_mesh_name(command.output.file)) {
    take_options_of(scene::read_gltf_source(command.input.file).options, command);
  }
  if (!command.object.empty()) gltf.object = command.object;
}

void check_gltf_options(const Generate& command) {
  if (command.is_unlit && command.is_compatible) {
    throw InputError({.file = "--unlit"},
                     "is an extension, and --compatible is for viewers that know none; leave one out");
  }
  if (command.gltf.look == scene::GltfLook::kCompatible &&
      (command.gltf.is_quantized || command.gltf.is_packed)) {
    throw InputError({.file = command.gltf.is_quantized ? "--quantize" : "--meshopt"},
                     "is an extension, and --compatible is for viewers that know none; leave one out");
  }
  if (command.output.is_standard() && command.gltf.images_in == scene::GltfImages::kSeparate) {
    throw InputError({.file = "--images"}, "separate needs a folder, and -o - is standard output alone");
  }
  if (!scene::is_mesh_name(command.output.file)) {
    if (command.options->count("--position-bits") > 0 && !command.gltf.is_quantized) {
      throw InputError({.file = "--position-bits"}, "is for quantized positions; add --quantize");
    }
    return;
  }
  if (command.options->count("--texel-density") > 0 && !scene::holds_textures(command.output.file)) {
    throw InputError({.file = "--texel-density"},
                     "is for .glb, .gltf and .obj: other formats hold no textures");
  }
  for (const auto& [option, lack] : kGltfOptions) {
    if (command.options->count(option) == 0) continue;
    throw InputError({.file = option}, std::string("is for .glb and .gltf: other formats hold no ") + lack);
  }
}

void generate(const Generate& command) {
  const Output& output = command.output;
  if (output.is_json && !output.explains && command.values.empty()) {
    throw InputError({.file = "--json"}, "prints tables; add --explain or --each");
  }
  if (output.file.empty() && !output.explains) throw InputError("-o FILE is needed (or --explain)");
  check_gltf_options(command);
  try {
    command.values.empty() ? generate_one(command) : generate_each(command);
  } catch (const InputError& error) {
    const std::string hint = folder_hint(command.input, error);
    if (hint.empty()) throw;
    throw InputError(error.place(), error.problem() + hint);
  }
}

}  // namespace

void check_model_name(const std::string& file) {
  if (file == "-" || scene::is_mesh_name(file)) return;
  const std::string extension = std::filesystem::path(file).extension();
  if (extension != ".glb" && extension != ".gltf") {
    throw InputError({.file = file}, "a model's name ends in .glb, .gltf, .obj, .ply, .stl or .off");
  }
}

bool keeps_scene(const Generate& command, const std::string& file) {
  return !command.forgets_scene && !scene::is_mesh_name(file);
}

scene::Request model_request(const std::string& file, const scene::GltfOptions& options) {
  const bool is_mesh = scene::is_mesh_name(file);
  return {.product = scene::Request::Product::kMeshFile,
          .has_textures = !is_mesh || scene::holds_textures(file),
          .has_texcoords = !is_mesh || scene::holds_texcoords(file),
          .has_thicknesses = !is_mesh,
          .has_normal_maps = is_mesh || options.look != scene::GltfLook::kUnlit,
          .has_tangents = !is_mesh};
}

MadeFile make_file(const scene::Document& document, const scene::Plan& plan, const std::string& file,
                   const scene::GltfOptions& options, bool looks_for_findings) {
  scene::Model model = scene::build(document, plan, options.images);
  if (options.levels > 0) scene::add_levels(model, document, plan, options.levels);
  MadeFile made{
      .objects = document.objects.size(), .instances = model.scene.objects.size(), .ledger = model.ledger};
  const auto keep = [&](const std::vector<scene::NamedBytes>& parts, const scene::Ledger& ledger) {
    write(parts, file);
    made.ledger.add(ledger);
    for (const scene::NamedBytes& part : parts) made.bytes += part.bytes.size();
  };
  if (scene::is_mesh_name(file)) {
    const scene::MeshOutput output = scene::make_mesh_output(
        model.scene, plan, file, {options.bake_size, options.images, options.texel_density, options.threads});
    keep(output.files, output.ledger);
    made.triangles = output.triangles;
  } else {
    const scene::GltfPieces gltf = scene::make_gltf_pieces(model.scene, plan, file, options);
    write(gltf, file);
    made.ledger.add(gltf.ledger);
    for (const scene::GltfPieces::File& part : gltf.files) {
      for (const std::span<const std::byte> piece : part.pieces) made.bytes += piece.size();
    }
    made.targets = gltf.targets;
    made.grow_error = gltf.grow_error;
    for (std::size_t i = 0; i < model.scene.meshes.size(); ++i) {
      (i < document.objects.size() ? made.triangles : made.coarser_triangles) +=
          model.scene.meshes[i].triangles.size();
    }
    made.triangles -= gltf.triangles_without_area;
    made.triangles_without_area = gltf.triangles_without_area;
  }
  if (looks_for_findings) made.findings = scene::check(document, model, scene::Thoroughness::kQuick);
  for (const scene::Object& object : model.scene.objects) {
    const std::optional<double> deviation = scene::deviation_of(model, object);
    if (deviation) made.deviation = std::max(made.deviation.value_or(0), *deviation);
  }
  return made;
}

void add_generate(CLI::App& app) {
  const auto command = std::make_shared<Generate>();
  CLI::App& sub =
      *app.add_subcommand("generate", "Make the scene's objects a textured glTF file, or a mesh file");
  add_scene_input(sub, command->input);
  sub.add_option("-o", command->output.file,
                 "Ends in .glb (all in one), .gltf (buffer and images beside it), .obj (materials and images "
                 "beside it), .ply, .stl or .off; - is a .glb to standard output. With --each a pattern such "
                 "as vase_{row}.glb")
      ->type_name("FILE");
  sub.add_option("--each", command->values, "Make a file for each row of this table, as told below")
      ->type_name("VALUES.csv");
  sub.add_option("--threads", command->threads,
                 "Threads that bake textures, and of --each those that make files; without it as many as the "
                 "machine has. The files are the same")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
  sub.add_option("--object", command->object, "This object alone")->type_name("NAME");
  sub.add_option(
         "--bake-size", command->gltf.bake_size,
         "Texels on the longer side of the image that a procedural texture becomes; the other follows "
         "the object, a sixteenth at least, and a strip longer than that has up to 4 N along it")
      ->capture_default_str()
      ->type_name("N")
      ->check(CLI::Range(1, kMostTexels));
  add_texel_density(sub, command->gltf.texel_density)->excludes("--bake-size");
  sub.add_flag(
      "--tangents", command->gltf.has_tangents,
      "A tangent with handedness at every vertex of every mesh; without it of those with a normal map");
  sub.add_flag("--unlit", command->is_unlit,
               "Colours and textures as they are, whatever the light (KHR_materials_unlit)");
  sub.add_flag("--compatible", command->is_compatible,
               "For viewers without extensions: none is used, and glass is blended with what is behind it");
  sub.add_option("--copyright", command->gltf.copyright,
                 "A line that the file keeps, such as \"2026 A. Potter\"")
      ->type_name("TEXT");
  sub.add_flag("--no-extras", command->forgets_scene,
               "Without the scene, which the file else keeps so that it can be made again from itself");
  sub.add_option("--images", command->images,
                 "Where images go, embedded or separate; without it into a .glb, beside a .gltf")
      ->type_name("PLACE")
      ->check(CLI::IsMember({"embedded", "separate"}));
  sub.add_option("--image-format", command->image_format,
                 "Of all images, png or jpg; without it PNG and JPEG files are copied as they are and others "
                 "become PNG")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"png", "jpg"}));
  sub.add_option("--max-texture", command->gltf.max_texture,
                 "Most texels on a side of an image; larger ones are made smaller")
      ->type_name("N")
      ->check(CLI::Range(1, kMostTexels));
  sub.add_flag("--quantize", command->gltf.is_quantized,
               "Vertices in less than half the bytes (KHR_mesh_quantization, which the viewer must know): "
               "positions in 16 bits, normals and tangents in 8, (u,v) in 16");
  sub.add_option(
         "--position-bits", command->gltf.position_bits,
         "Of --quantize: the longest side of an object's box in 2^N - 1 steps; without it 16, and with "
         "--meshopt as many as its cells need, 8 to 14")
      ->type_name("N")
      ->check(CLI::Range(8, 16));
  sub.add_flag(
      "--meshopt", command->gltf.is_packed,
      "Vertices and triangles packed (EXT_meshopt_compression, which the viewer must know), (u,v) only "
      "where there is a texture; with --quantize smallest");
  sub.add_flag(
      "--minimal", command->gltf.is_minimal,
      "Only what shows the objects: no names, no camera, no extras (the file cannot be made again from "
      "itself), and (u,v) only where there is a texture");
  sub.add_option(
         "--lod", command->gltf.levels,
         "Levels of detail (MSFT_lod): at most N coarser meshes of what is swept or revolved, made from "
         "the same curves, each for half the height in the picture of the one before")
      ->type_name("N")
      ->check(CLI::Range(1, scene::kMostLevels));
  sub.add_option("--turntable", command->gltf.turntable_seconds,
                 "An animation: everything turns once about its middle, counter-clockwise from above")
      ->type_name("SECONDS")
      ->check(CLI::Range(kLeastSeconds, kMostSeconds));
  sub.add_option("--grow", command->gltf.grow_seconds,
                 "An animation: what is swept or revolved grows from its start to its end")
      ->type_name("SECONDS")
      ->check(CLI::Range(kLeastSeconds, kMostSeconds));
  add_explain(sub, command->output);
  add_json(sub, command->output, "Print tables as JSON: that of --explain; with --each also one of the rows");
  add_quiet(sub, command->output);
  sub.footer(
      "The table of --each is CSV. Its first row holds pointers such as /objects/0/sweep/twist_deg,\n"
      "every other row the values that the scene gets there, as --set has them and after --set; an\n"
      "empty cell leaves the scene's own. In -o's name {row} is the row's number and {POINTER} the\n"
      "row's value in that column. A row that cannot be made is reported, the others are made, and\n"
      "the exit status is 2. --explain tells what any row needs and what all cost; without -o it\n"
      "reads every row and makes none.\n\n"
      "A .glb or .gltf keeps the scene and these options, and can be the SCENE: it is made again with the\n"
      "same bytes, or with what --set and other options change. Files that its scene names are looked for\n"
      "from its own folder, or from --files-in.\n\n"
      "Without a scene file two curves and what else is wanted make one object.\n\n"
      "Examples:\n"
      "  sweepkit generate --contour circle:0.1 --trajectory helix:radius=1,pitch=0.3,turns=4 -o spring.glb\n"
      "  sweepkit generate samples/scenes/vase_and_cup.json -o vase_and_cup.glb\n"
      "  sweepkit generate samples/scenes/vase_and_cup.json --object vase -o vase.stl\n"
      "  sweepkit generate spring.glb --set /objects/0/sweep/twist_deg=90 -o twisted.glb\n"
      "  sweepkit generate samples/scenes/vase_and_cup.json --object vase --each samples/tables/vases.csv "
      "-o vase_{row}.glb");
  command->options = &sub;
  sub.callback([command] {
    settle_gltf_options(*command);
    generate(*command);
  });
}

}  // namespace sweepkit::tools
