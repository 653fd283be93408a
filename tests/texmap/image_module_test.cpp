// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "sweepkit/texmap/file_image.hpp"
#include "sweepkit/texmap/image_file.hpp"
#include "sweepkit/texmap/texture.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"

// How a program that starts afresh finds the image module: this program is run again, also from elsewhere.
namespace sweepkit::texmap {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModule = "sweepkit-image-files.so";
// Any test that needs the module.
constexpr const char* kOneTest = " --gtest_filter=ImageFile.LinearDataSurvivesPngToTheBit";

class ImageModule : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("sweepkit_module_" + std::to_string(getpid()));
    fs::create_directories(folder_ / "bin");
  }
  void TearDown() override { fs::remove_all(folder_); }

  struct Outcome {
    int status = -1;
    std::string text;
  };
  static Outcome run(const std::string& command) {
    Outcome outcome;
    FILE* pipe = popen(("exec 2>&1; " + command).c_str(), "r");
    if (pipe == nullptr) return outcome;
    std::array<char, 4096> part{};
    while (const std::size_t size = fread(part.data(), 1, part.size(), pipe))
      outcome.text.append(part.data(), size);
    const int status = pclose(pipe);
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
  }
  static std::string quoted(const fs::path& path) {
    std::string text(1, '\'');
    text.append(path.string()).push_back('\'');
    return text;
  }

  fs::path folder_;
  fs::path program_ = fs::canonical("/proc/self/exe");
};

TEST_F(ImageModule, IsFoundInTheFolderOfTheProgram) {
  const Outcome outcome = run("cd / && " + quoted(program_) + kOneTest);
  EXPECT_EQ(outcome.status, 0) << outcome.text;
}

TEST_F(ImageModule, IsFoundWhereItIsInstalled) {
  fs::copy_file(program_, folder_ / "bin" / "program");
  fs::create_directories(folder_ / "lib" / "sweepkit");
  fs::copy_file(program_.parent_path() / kModule, folder_ / "lib" / "sweepkit" / kModule);
  const Outcome outcome = run(quoted(folder_ / "bin" / "program") + kOneTest);
  EXPECT_EQ(outcome.status, 0) << outcome.text;
}

TEST_F(ImageModule, IsFoundThroughPathWhateverLiesInTheWorkingFolder) {
  // argv[0] is then a bare name; what has that name here is not the program, and a module beside it is not
  // ours: loading it would run foreign code.
  fs::create_directories(folder_ / program_.filename());
  std::FILE* foreign = std::fopen((folder_ / kModule).c_str(), "w");
  ASSERT_NE(foreign, nullptr);
  std::fclose(foreign);
  const Outcome outcome = run("cd " + quoted(folder_) + " && PATH=" + quoted(program_.parent_path()) + " " +
                              program_.filename().string() + kOneTest);
  EXPECT_EQ(outcome.status, 0) << outcome.text;
}

TEST_F(ImageModule, TellsWhereItWasLookedForIfItIsMissing) {
  fs::copy_file(program_, folder_ / "bin" / "program");
  const Outcome outcome = run(quoted(folder_ / "bin" / "program") + kOneTest);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.text.find("the image module cannot be loaded ("), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find((folder_ / "bin" / kModule).string()), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("lib/sweepkit"), std::string::npos) << outcome.text;
}

// Ends the process: 0 if the module was loaded by the first image and not before.
[[noreturn]] void use_images_last() {
  const Image image{1, 1, 3, std::vector<std::uint16_t>{1, 2, 3}};
  TileCache tiles;
  FilterThread thread(tiles);
  TextureSampler({std::make_shared<const Image>(image)}, Filter::kIntegral1, tiles, 0).over_box({}, thread);
  point_sample(Procedural{}, {0.5, 0.5}, {});
  image_format("a.png");
  const bool is_loaded_early = is_image_module_loaded();
  encode_image(image, ImageFormat::kPng);
  std::exit(!is_loaded_early && is_image_module_loaded() ? 0 : 1);
}

// Ends the process: 0 if the module is there without an image.
[[noreturn]] void load_by_hand() {
  const bool is_loaded_early = is_image_module_loaded();
  load_image_module();
  std::exit(!is_loaded_early && is_image_module_loaded() ? 0 : 1);
}

TEST(ImageModuleDeathTest, IsLoadedBeforeAnyImageWhereThatIsAskedFor) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(load_by_hand(), testing::ExitedWithCode(0), "");
}

TEST(ImageModuleDeathTest, IsNotLoadedBeforeAnImageIsReadOrWritten) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a fresh process, in which no test has read an image
  EXPECT_EXIT(use_images_last(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace sweepkit::texmap
