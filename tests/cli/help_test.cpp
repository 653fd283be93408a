// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Every --help has an example, and every example works as it stands, in a folder that has the samples.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

class Help : public testing::TestWithParam<std::string> {};

TEST_P(Help, HasExamplesThatWork) {
  const std::filesystem::path page =
      std::filesystem::path(SWEEPKIT_PROGRAM).parent_path() / "sweepkit-view.html";
  if (GetParam() == "view" && !std::filesystem::exists(page)) {
    ASSERT_EQ(std::getenv("CI"), nullptr) << "in CI the page is bundled";
    GTEST_SKIP() << "SKIPPED: this build has no page; scripts/setup, and build again";
  }
  const Workshop workshop;
  std::filesystem::create_directory_symlink(SWEEPKIT_SAMPLES, workshop.folder() / "samples");
  const Outcome help = workshop.shell("sweepkit " + GetParam() + " --help");
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  std::istringstream lines(help.out.substr(std::min(help.out.find("Example"), help.out.size())));
  int examples = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, 11, "  sweepkit ") != 0) continue;
    ++examples;
    const Outcome run = workshop.shell(line);
    EXPECT_EQ(run.status, 0) << line << '\n' << run.err;
    // What stands after -o is there, and is no empty file.
    const std::size_t output = line.find(" -o ");
    if (output == std::string::npos) {
      EXPECT_NE(run.out, "") << line;
    } else {
      std::istringstream words(line.substr(output + 4));
      std::string file;
      words >> file;
      for (const std::string number : {"{row}", "{frame}"}) {
        const std::size_t at = file.find(number);
        if (at != std::string::npos) file.replace(at, number.size(), 1, '1');
      }
      EXPECT_NE(workshop.read(file), "") << line;
    }
  }
  EXPECT_GE(examples, 1) << help.out;
}

INSTANTIATE_TEST_SUITE_P(OfTheProgram, Help, testing::Values(""), [](const auto&) { return "itself"; });
INSTANTIATE_TEST_SUITE_P(OfTheCommand, Help,
                         testing::Values("generate", "render", "assemble", "bake", "info", "check", "view",
                                         "schema"),
                         [](const auto& test) { return test.param; });

TEST(Version, IsAWordAndANumber) {
  const Outcome run = Workshop().sweepkit({"--version"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out.substr(0, 9), "sweepkit ");
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '.'), 2);
  EXPECT_EQ(run.err, "");
}

}  // namespace
}  // namespace sweepkit::test
