// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Every option of a picture that cannot be is one line with a remedy and status 2, before any work.

#include <gtest/gtest.h>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

struct Refusal {
  std::string name;
  std::vector<std::string> options;  ///< after "render scene.json"
  std::string message;               ///< after "sweepkit: "
};

void PrintTo(const Refusal& refusal, std::ostream* stream) {
  *stream << refusal.message;
}

class PictureOption : public testing::TestWithParam<Refusal> {};

TEST_P(PictureOption, IsRefusedInOneLineAndLeavesNoFile) {
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall, R"("camera": {"width": 40, "height": 30})"));
  const auto before = workshop.contents();
  std::vector<std::string> arguments = {"render", "scene.json"};
  arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
  const Outcome run = workshop.sweepkit(arguments);
  EXPECT_EQ(run.err, "sweepkit: " + GetParam().message + "\n");
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(workshop.contents(), before);
}

INSTANTIATE_TEST_SUITE_P(
    OfTheGoal, PictureOption,
    testing::Values(
        Refusal{"NoError",
                {"-o", "p.png", "--error", "0"},
                "--error: Value 0 not in range 0.000001 to 1.000000; see sweepkit render --help"},
        Refusal{"NoTime",
                {"-o", "p.png", "--time", "-1"},
                "--time: Value -1 not in range 0.001000 to 1000000.000000; see sweepkit render --help"},
        Refusal{"Both",
                {"-o", "p.png", "--error", "0.1", "--time", "1"},
                "--error: cannot be reached within --time; leave out one of the two"},
        Refusal{"ErrorAndAntialias",
                {"-o", "p.png", "--error", "0.1", "--antialias", "3x3"},
                "--error: chooses the antialiasing itself; leave out --antialias"},
        Refusal{"TimeAndAntialias",
                {"-o", "p.png", "--time", "1", "--antialias", "adaptive"},
                "--time: chooses the antialiasing itself; leave out --antialias"},
        Refusal{"ErrorOfATile",
                {"-o", "p.png", "--error", "0.1", "--tile", "1/2"},
                "--error: is for the whole picture, which a part cannot judge; leave out --tile"},
        Refusal{"ErrorByStages",
                {"-o", "p.png", "--error", "0.1", "--progressive"},
                "--error: refines a picture before it is written; leave out --progressive"},
        Refusal{"TimeOfFrames",
                {"-o", "p_{frame}.png", "--time", "1", "--frames", "1-2"},
                "--time: is for one picture; leave out --frames"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    OfTheFile, PictureOption,
    testing::Values(
        Refusal{"TwelveBits",
                {"-o", "p.png", "--bits", "12"},
                "--bits: 12 not in {8,16,32}; see sweepkit render --help"},
        Refusal{"FloatPng", {"-o", "p.png", "--bits", "32"}, "--bits: a PNG file has 8 or 16 bits, got 32"},
        Refusal{"FloatTiff", {"-o", "p.tif", "--bits", "32"}, "--bits: a TIFF file has 8 or 16 bits, got 32"},
        Refusal{"DeepJpeg", {"-o", "p.jpg", "--bits", "16"}, "--bits: a JPEG file has 8 bits, got 16"},
        Refusal{"ShallowExr",
                {"-o", "p.exr", "--bits", "8"},
                "--bits: an EXR file has 16 (half) or 32 (float) bits, got 8"},
        Refusal{"AlphaInJpeg",
                {"-o", "p.jpg", "--alpha"},
                "--alpha: a JPEG file has no alpha; write .png, .tif or .exr"},
        Refusal{"ExposureInWords",
                {"-o", "p.png", "--exposure", "bright"},
                "Could not convert: --exposure = bright; see sweepkit render --help"},
        Refusal{"ExposureBeyondFloats",
                {"-o", "p.png", "--exposure", "65"},
                "--exposure: needs -64 to 64 stops, got 65"},
        Refusal{"ExposureOfNan",
                {"-o", "p.png", "--exposure", "nan"},
                "--exposure: needs -64 to 64 stops, got nan"},
        Refusal{"UnknownLayer",
                {"-o", "p.png", "--aov", "depth,colour"},
                "--aov: colour not in {depth,normal,uv,object-id,footprint,rays}; see sweepkit render "
                "--help"},
        Refusal{"LayerTwice",
                {"-o", "p.png", "--aov", "depth,uv,depth"},
                "--aov: has \"depth\" twice; once is enough"},
        Refusal{"LayersBesideStandardOutput",
                {"-o", "-", "--aov", "depth"},
                "--aov: writes files beside the picture, which standard output has none of; add --format "
                "exr"},
        Refusal{"StatisticsOverALayer",
                {"-o", "p.png", "--aov", "depth", "--stats", "p.depth.exr"},
                "--stats: needs another file than -o, got \"p.depth.exr\" for both"},
        Refusal{"LayerInAMissingFolder",
                {"-o", "none/p.png", "--aov", "depth"},
                "none/p.png: there is no folder none; make it first"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    OfAPart, PictureOption,
    testing::Values(
        Refusal{"CropOfThreeNumbers",
                {"-o", "p.png", "--crop", "1,2,3"},
                "--crop: needs X,Y,WIDTH,HEIGHT in pixels from the top left, such as 100,50,64,48, got "
                "\"1,2,3\""},
        Refusal{"CropInWords",
                {"-o", "p.png", "--crop", "1,2,3,x"},
                "--crop: needs X,Y,WIDTH,HEIGHT in pixels from the top left, such as 100,50,64,48, got "
                "\"1,2,3,x\""},
        Refusal{"CropOfNothing",
                {"-o", "p.png", "--crop", "0,0,0,5"},
                "--crop: needs pixels inside the picture of 40 x 30, got 0 x 5 at 0,0"},
        Refusal{"CropOutside",
                {"-o", "p.png", "--crop", "35,0,6,5"},
                "--crop: needs pixels inside the picture of 40 x 30, got 6 x 5 at 35,0"},
        Refusal{"CropFromBelowZero",
                {"-o", "p.png", "--crop=-1,0,6,5"},
                "--crop: needs pixels inside the picture of 40 x 30, got 6 x 5 at -1,0"},
        Refusal{"CropBeyondIntegers",
                {"-o", "p.png", "--crop", "0,0,99999999999,5"},
                "--crop: needs X,Y,WIDTH,HEIGHT in pixels from the top left, such as 100,50,64,48, got "
                "\"0,0,99999999999,5\""},
        Refusal{"TileNumberNone",
                {"-o", "p.png", "--tile", "0/4"},
                "--tile: needs I/N, part I of 1 to N of a picture, N at most 32768, such as 1/4, got "
                "\"0/4\""},
        Refusal{"TileBeyondTheLast",
                {"-o", "p.png", "--tile", "5/4"},
                "--tile: needs I/N, part I of 1 to N of a picture, N at most 32768, such as 1/4, got "
                "\"5/4\""},
        Refusal{"TileAlone",
                {"-o", "p.png", "--tile", "2"},
                "--tile: needs I/N, part I of 1 to N of a picture, N at most 32768, such as 1/4, got \"2\""},
        Refusal{"MoreTilesThanRows",
                {"-o", "p.png", "--tile", "1/31"},
                "--tile: needs a row of pixels for each tile: 31 tiles of 30 rows; ask for fewer tiles"},
        Refusal{"JpegTile",
                {"-o", "p.jpg", "--tile", "1/4"},
                "--tile: JPEG files cannot be put together without loss; write .png, .tif or .exr"}),
    [](const auto& test) { return test.param.name; });

const std::string kFramesNeed =
    "--frames: needs frames of 0 to 999999, such as 7, 1-120, 1-120:2 or 3,5-10, got ";

INSTANTIATE_TEST_SUITE_P(
    OfFrames, PictureOption,
    testing::Values(
        Refusal{"Words", {"-o", "{frame}.png", "--frames", "all"}, kFramesNeed + "\"all\""},
        Refusal{"NoStep", {"-o", "{frame}.png", "--frames", "1-9:0"}, kFramesNeed + "\"1-9:0\""},
        Refusal{"StepOfOne", {"-o", "{frame}.png", "--frames", "5:2"}, kFramesNeed + "\"5:2\""},
        Refusal{"Negative", {"-o", "{frame}.png", "--frames=-3"}, kFramesNeed + "\"-3\""},
        Refusal{"HoleInTheList", {"-o", "{frame}.png", "--frames", "1,,3"}, kFramesNeed + "\"1,,3\""},
        Refusal{"BeyondTheLast", {"-o", "{frame}.png", "--frames", "1000000"}, kFramesNeed + "\"1000000\""},
        Refusal{"Backwards",
                {"-o", "{frame}.png", "--frames", "9-1"},
                "--frames: the frames 9-1 run backwards; write 1-9"},
        Refusal{
            "Twice", {"-o", "{frame}.png", "--frames", "1-5,3"}, "--frames: has frame 3 twice in \"1-5,3\""},
        Refusal{"OneName",
                {"-o", "p.png", "--frames", "1-5"},
                "-o: one name for 5 frames; put {frame} in it, such as turn_{frame}.png"},
        Refusal{"UnknownName",
                {"-o", "{row}.png", "--frames", "1-5"},
                "-o: there is no {row}; there is {frame}, and with a number of digits {frame:04}"},
        Refusal{"TooManyDigits",
                {"-o", "{frame:99}.png", "--frames", "1-5"},
                "-o: there is no {frame:99}; there is {frame}, and with a number of digits {frame:04}"},
        Refusal{"OpenBrace",
                {"-o", "{frame.png", "--frames", "1-5"},
                "-o: a brace lacks its other in \"{frame.png\"; with --frames a name holds no other braces "
                "than {frame}"},
        Refusal{"StandardOutput",
                {"-o", "-", "--frames", "1-5"},
                "-o: --frames makes a file a frame; name them, such as turn_{frame}.png"},
        Refusal{"MissingFolder",
                {"-o", "none/{frame}.png", "--frames", "1-5"},
                "none/1.png: there is no folder none; make it first"},
        Refusal{"StatisticsOverAFrame",
                {"-o", "{frame}.png", "--frames", "1-5", "--stats", "3.png"},
                "--stats: needs another file than -o, got \"3.png\" for both"},
        Refusal{"NoTurn",
                {"-o", "{frame}.png", "--frames", "1-5", "--frames-per-turn", "0"},
                "--frames-per-turn: Value 0 not in range 1 to 999999; see sweepkit render --help"},
        Refusal{"TurnWithoutFrames",
                {"-o", "p.png", "--frames-per-turn", "5"},
                "--frames-per-turn requires --frames; see sweepkit render --help"},
        Refusal{"PreviewsOfFrames",
                {"-o", "{frame}.png", "--frames", "1-5", "--progressive"},
                "--progressive: is for one picture; leave out --frames"},
        Refusal{"PreviewsOnStandardOutput",
                {"-o", "-", "--progressive"},
                "--progressive: writes its file several times, which standard output cannot be; name a file "
                "with -o"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace sweepkit::test
