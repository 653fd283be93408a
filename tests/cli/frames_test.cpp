// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Turntables, files that are there already, and previews: the files are those of single renders.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

using Arguments = std::vector<std::string>;

std::string scene_with(const std::string& more = "") {
  return scene_of(kBall + std::string(more),
                  R"("camera": {"eye": [0, 1, 4], "target": [0, 0, 0], "width": 40, "height": 30},
                     "lights": [{"directional": [-1, -1, -1]}])");
}

std::vector<std::string> names_in(const Workshop& workshop) {
  std::vector<std::string> names;
  for (const auto& [name, digest] : workshop.contents()) names.push_back(name);
  return names;
}

TEST(Frames, HaveTheirNumbersInTheirNames) {
  const Workshop workshop;
  workshop.write("scene.json", scene_with());
  Outcome run = workshop.sweepkit({"render", "scene.json", "-o", "a{frame}.png", "--frames", "3,8-12:2"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("a{frame}.png: 4 frames of 40 x 30 pixels in "), std::string::npos) << run.err;
  run = workshop.sweepkit({"render", "scene.json", "-o", "b_{frame:04}.exr", "--frames", "7", "--quiet"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(names_in(workshop), (std::vector<std::string>{"a03.png", "a08.png", "a10.png", "a12.png",
                                                          "b_0007.exr", "scene.json"}));
}

TEST(Frames, TurnTheCameraRoundTheTarget) {
  const Workshop workshop;
  workshop.write("scene.json", scene_with());
  ASSERT_EQ(workshop.sweepkit({"render", "scene.json", "-o", "f{frame}.png", "--frames", "1-4"}).status, 0);
  // Frame 1 of 4 is a quarter turn, whose eye is exact. The file of a frame says more of itself before its
  // pixels.
  const auto pixels = [&](const std::string& file) {
    const std::string bytes = workshop.read(file);
    return bytes.substr(bytes.find("IDAT"));
  };
  for (const auto& [frame, eye] : {std::pair{"1", "[4, 1, 0]"}, {"2", "[0, 1, -4]"}, {"4", "[0, 1, 4]"}}) {
    ASSERT_EQ(workshop
                  .sweepkit({"render", "scene.json", "-o", "single.png", "--set",
                             std::string("/camera/eye=") + eye})
                  .status,
              0);
    EXPECT_TRUE(pixels("single.png") == pixels(std::string("f") + frame + ".png")) << frame;
  }
  EXPECT_FALSE(pixels("f1.png") == pixels("f2.png"));
}

TEST(Frames, AreTheSameAloneAndTogetherForAnyThreads) {
  const Workshop workshop;
  workshop.write("scene.json", scene_with());
  ASSERT_EQ(workshop
                .sweepkit({"render", "scene.json", "-o", "all{frame}.png", "--frames", "0-5", "--threads",
                           "7", "--aov", "depth"})
                .status,
            0);
  ASSERT_EQ(workshop
                .sweepkit({"render", "scene.json", "-o", "one{frame}.png", "--frames", "4",
                           "--frames-per-turn", "6", "--threads", "1", "--aov", "depth"})
                .status,
            0);
  EXPECT_EQ(workshop.read("all4.png"), workshop.read("one4.png"));
  EXPECT_EQ(workshop.read("all4.depth.exr"), workshop.read("one4.depth.exr"));
}

class SkipExisting : public testing::Test {
 protected:
  void SetUp() override {
    workshop_.write("scene.json", scene_with());
    workshop_.write("line.csv", "0,0,0\n0,1,0\n");
  }
  // How many of the frames were drawn.
  std::size_t drawn(const Arguments& more = {}) const {
    Arguments arguments = {"render", "scene.json",     "-o", "f{frame}.png", "--frames",
                           "1-3",    "--skip-existing"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = workshop_.sweepkit(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    const std::string begin = "f{frame}.png: ";
    EXPECT_EQ(run.err.find(begin), 0u) << run.err;
    return std::stoul(run.err.substr(begin.size()));
  }

  Workshop workshop_;
};

TEST_F(SkipExisting, DrawsWhatIsMissingDamagedOrForeignAndNothingElse) {
  EXPECT_EQ(drawn(), 3u);
  EXPECT_EQ(drawn(), 0u);
  const auto whole = workshop_.contents();
  std::filesystem::remove(workshop_.folder() / "f2.png");
  EXPECT_EQ(drawn(), 1u);
  workshop_.write("f3.png", "no picture");
  EXPECT_EQ(drawn(), 1u);
  workshop_.shell("cp f1.png f2.png");
  EXPECT_EQ(drawn(), 1u);
  EXPECT_EQ(workshop_.contents(), whole);
}

TEST_F(SkipExisting, TakesFramesOfARunWithoutIt) {
  ASSERT_EQ(workshop_.sweepkit({"render", "scene.json", "-o", "f{frame}.png", "--frames", "1-3"}).status, 0);
  EXPECT_EQ(drawn(), 0u);
}

TEST_F(SkipExisting, DrawsAgainWhatTheSceneOrTheOptionsChange) {
  drawn();
  EXPECT_EQ(drawn({"--threads", "1"}), 0u) << "the picture is the same";
  EXPECT_EQ(drawn({"--texture-memory", "64"}), 0u);
  for (const Arguments& more : {Arguments{"--size", "20x20"},
                                {"--set", "/ambient=[1, 1, 1]"},
                                {"--antialias", "3x3"},
                                {"--exposure", "1"},
                                {"--bits", "16"},
                                {"--alpha"},
                                {"--depth", "2"},
                                {"--filter", "point"},
                                {"--crop", "0,0,5,5"},
                                {"--frames-per-turn", "9"},
                                {"--footprint", "neighbours"}}) {
    EXPECT_EQ(drawn(more), 3u) << more.front();
    EXPECT_EQ(drawn(more), 0u) << more.front();
  }
}

TEST_F(SkipExisting, SeesTheFilesThatTheSceneNames) {
  workshop_.write(
      "scene.json",
      scene_with(
          R"(, {"name": "line", "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"csv": "line.csv"}}})"));
  drawn();
  EXPECT_EQ(drawn(), 0u);
  workshop_.write("line.csv", "0,0,0\n0,2,0\n");
  EXPECT_EQ(drawn(), 3u);
}

TEST_F(SkipExisting, MissesALayersFileAndWorksForASinglePictureOfEveryFormat) {
  drawn({"--aov", "depth,uv"});
  EXPECT_EQ(drawn({"--aov", "depth,uv"}), 0u);
  std::filesystem::remove(workshop_.folder() / "f2.uv.exr");
  EXPECT_EQ(drawn({"--aov", "depth,uv"}), 1u);
  for (const char* file : {"p.png", "p.jpg", "p.tif", "p.exr"}) {
    const Arguments render = {"render", "scene.json", "-o", file, "--skip-existing", "--stats", "s.json"};
    EXPECT_NE(workshop_.sweepkit(render).err.find("40 x 30 pixels in"), std::string::npos) << file;
    const std::string before = workshop_.read(file);
    EXPECT_EQ(workshop_.sweepkit(render).err, std::string(file) + ": is there already\n");
    EXPECT_EQ(workshop_.read(file), before);
    EXPECT_NE(workshop_.read("s.json").find("\"pictures\": 0,"), std::string::npos);
  }
}

TEST(Progressive, EndsWithTheSameBytesAndSaysItsStages) {
  const Workshop workshop;
  workshop.write("scene.json", scene_with());
  for (const char* extension : {".png", ".exr"}) {
    const std::string plain = std::string("plain") + extension;
    const std::string refined = std::string("refined") + extension;
    const Arguments options = {"--antialias", "3x3", "--alpha", "--aov", "normal"};
    const auto draw = [&](const std::string& file, const Arguments& more) {
      Arguments arguments = {"render", "scene.json", "-o", file};
      arguments.insert(arguments.end(), options.begin(), options.end());
      arguments.insert(arguments.end(), more.begin(), more.end());
      const Outcome run = workshop.sweepkit(arguments);
      EXPECT_EQ(run.status, 0) << run.err;
      return run.err;
    };
    draw(plain, {});
    const std::string said = draw(refined, {"--progressive", "--threads", "2"});
    EXPECT_EQ(workshop.read(refined), workshop.read(plain));
    for (const char* stage : {"8 x 8", "4 x 4", "2 x 2"})
      EXPECT_NE(said.find(refined + ": a preview by a ray for each " + stage + " pixels\n"),
                std::string::npos)
          << said;
  }
  EXPECT_EQ(workshop.read("plain.normal.exr"), workshop.read("refined.normal.exr"));
}

// Waits for the first file to be there, and then a little.
void interrupt_after_first(const Workshop& workshop, const Arguments& arguments, const std::string& first,
                           useconds_t after) {
  const pid_t child = workshop.start(arguments);
  for (int i = 0; i < 20000 && !std::filesystem::exists(workshop.folder() / first); ++i) usleep(1000);
  usleep(after);
  kill(child, SIGINT);
  int wait_status = 0;
  waitpid(child, &wait_status, 0);
  EXPECT_TRUE(exit_status(wait_status) == 130 || exit_status(wait_status) == 0);
}

// r01.png for f01.png.
std::string reference_of(std::string name) {
  name.front() = 'r';
  return name;
}

TEST(Interrupt, OfFramesLeavesWholeOnesAloneAndTheRestIsDrawnLater) {
  const Workshop workshop;
  workshop.write("scene.json", scene_with());
  const Arguments reference = {"render", "scene.json", "-o", "r{frame:02}.png", "--frames", "1-40"};
  ASSERT_EQ(workshop.sweepkit(reference).status, 0);
  const Arguments again = {"render", "scene.json",     "-o", "f{frame:02}.png", "--frames",
                           "1-40",   "--skip-existing"};
  for (const useconds_t after : {0u, 3000u, 20000u}) {
    interrupt_after_first(workshop, again, "f01.png", after);
    for (const std::string& name : names_in(workshop)) {
      EXPECT_TRUE(name == "scene.json" || name[0] == 'r' || name[0] == 'f') << "left behind: " << name;
      if (name[0] == 'f') {
        EXPECT_EQ(workshop.read(name), workshop.read(reference_of(name)));
      }
    }
  }
  ASSERT_EQ(workshop.sweepkit(again).status, 0);
  for (int i = 10; i <= 40; ++i) {
    const std::string number = std::to_string(i);
    const std::string name = std::string(1, 'f').append(number).append(".png");
    EXPECT_EQ(workshop.read(name), workshop.read(reference_of(name)));
  }
}

TEST(Interrupt, OfAPreviewLeavesAWholePictureThatIsNotTakenForTheLast) {
  const Workshop workshop;
  workshop.write("scene.json", scene_with());
  // Some seconds of work, interrupted when the first preview is there.
  interrupt_after_first(workshop,
                        {"render", "scene.json", "-o", "p.png", "--progressive", "--size", "1600x1200",
                         "--antialias", "3x3", "--skip-existing"},
                        "p.png", 0);
  EXPECT_EQ(names_in(workshop), (std::vector<std::string>{"p.png", "scene.json"}));
  const Outcome info = workshop.sweepkit({"info", "p.png"});
  EXPECT_EQ(info.status, 0) << info.err;
  EXPECT_NE(info.out.find("width: 1600"), std::string::npos);
  // A mark stands in a PNG as plain text.
  EXPECT_EQ(workshop.read("p.png").find("sweepkit-picture"), std::string::npos);
}

TEST(Frames, OntoAFullDiskKeepWhatIsWholeAndLeaveNoPart) {
  const Workshop workshop;
  workshop.write("scene.json", scene_with());
  ASSERT_EQ(workshop.sweepkit({"render", "scene.json", "-o", "r1.tif", "--frames", "1"}).status, 0);
  // Every file may have 1 KiB; a TIFF of 40 x 30 pixels has more.
  const auto before = workshop.contents();
  const Outcome run =
      workshop.shell("ulimit -f 1; sweepkit render scene.json -o f{frame}.tif --frames 1-3 --bits 16");
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "sweepkit: f1.tif: cannot be written: File too large\n");
  EXPECT_EQ(workshop.contents(), before);
}

}  // namespace
}  // namespace sweepkit::test
