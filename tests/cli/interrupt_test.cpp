// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// Ctrl-C, at any moment of the work, ends the program with 130 and leaves the folder as it was or the result
// whole.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

int interrupted_status(const Workshop& workshop, const std::vector<std::string>& arguments, int signal,
                       useconds_t after) {
  const pid_t child = workshop.start(arguments);
  usleep(after);
  kill(child, signal);
  int wait_status = 0;
  waitpid(child, &wait_status, 0);
  return exit_status(wait_status);
}

TEST(Interrupt, InTheMiddleOfARenderEndsWith130AndLeavesNothing) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  const auto before = workshop.contents();
  // Many seconds of work, interrupted after a third of one.
  EXPECT_EQ(interrupted_status(workshop, {"render", "ball.json", "-o", "ball.png", "--size", "8000x8000"},
                               SIGINT, 300000),
            130);
  EXPECT_EQ(workshop.contents(), before);
}

TEST(Interrupt, ByAPoliteKillLeavesNothingEither) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall));
  const auto before = workshop.contents();
  EXPECT_EQ(interrupted_status(workshop, {"render", "ball.json", "-o", "ball.png", "--size", "8000x8000"},
                               SIGTERM, 300000),
            128 + SIGTERM);
  EXPECT_EQ(workshop.contents(), before);
}

// A few milliseconds of work, and a signal in every part of it, the writing too.
TEST(Interrupt, AtAnyMomentLeavesTheWholeResultOrNone) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall, R"("camera": {"width": 8, "height": 8})"));
  const auto before = workshop.contents();
  ASSERT_EQ(workshop.sweepkit({"generate", "ball.json", "-o", "ball.gltf"}).status, 0);
  const auto after = workshop.contents();
  for (useconds_t moment = 0; moment < 12000; moment += 150) {
    for (const auto& [name, bytes] : after) {
      if (before.count(name) == 0) std::filesystem::remove(workshop.folder() / name);
    }
    const int status =
        interrupted_status(workshop, {"generate", "ball.json", "-o", "ball.gltf"}, SIGINT, moment);
    // Before main() has set the handler the signal ends the program by itself, which reads the same.
    EXPECT_TRUE(status == 130 || status == 0) << status;
    for (const auto& [name, bytes] : workshop.contents()) {
      ASSERT_EQ(after.count(name), 1u) << "left behind after " << moment << " us: " << name;
      EXPECT_EQ(bytes, after.at(name)) << name << " after " << moment << " us";
    }
    if (status == 0) {
      EXPECT_EQ(workshop.contents(), after);
    }
  }
}

TEST(ClosedPipe, EndsTheProgramQuietly) {
  const Workshop workshop;
  workshop.write("ball.json", scene_of(kBall, R"("camera": {"width": 256, "height": 256})"));
  // 128 + SIGPIPE, which shells pass over; the reader has what it wanted.
  const Outcome run =
      workshop.shell("sweepkit render ball.json -o - --format tif | true; echo ${PIPESTATUS[0]}");
  EXPECT_EQ(run.out, "141\n");
  EXPECT_EQ(run.err, "");
}

}  // namespace
}  // namespace sweepkit::test
