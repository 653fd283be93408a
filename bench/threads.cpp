// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// What a second thread gains on a picture, beside what it gains on arithmetic alone, which shares no memory,
// takes no lock and is handed out in small pieces: a machine whose processors are busy with other work, or
// clocked down when both are used, slows both alike. Each round draws the picture and runs the loop with one
// thread and with two, and takes the ratio of the gains. Ends with 1 where the picture gains less than 0.93
// of what the loop gains.
//
// Usage: threads SCENE [SIDE]    the picture is SIDE x SIDE pixels, 2,048 unless said

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <thread>
#include <vector>

#include "harness.hpp"
#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/plan.hpp"

namespace {

using namespace sweepkit;

constexpr int kRounds = 5;
constexpr double kLeastShare = 0.93;
constexpr int kPieces = 256;

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A chain of products and sums in registers; its steps wait for each other, so nothing but the processor's
// clock decides how long it takes.
double run_piece(std::uint64_t steps) {
  double x = 0.5;
  for (std::uint64_t i = 0; i < steps; ++i) x = x * 0.999999 + 1e-7;
  return x;
}

void run_loop(int threads, std::uint64_t steps_a_piece) {
  std::atomic<int> next{0};
  const auto take_pieces = [&] {
    while (next.fetch_add(1) < kPieces) bench::keep(run_piece(steps_a_piece));
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(take_pieces);
  take_pieces();
  for (std::thread& other : others) other.join();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: threads SCENE [SIDE]\n");
    return 2;
  }
  if (std::thread::hardware_concurrency() < 2) {
    std::fprintf(stderr, "threads: SKIPPED: this machine has one processor\n");
    return 0;
  }
  try {
    scene::Document document = scene::read_document(argv[1]);
    document.width = document.height = argc == 3 ? std::atoi(argv[2]) : 2048;
    const scene::Plan plan = scene::plan(document, {.product = scene::Request::Product::kPicture,
                                                    .filter = render::Filter::kAuto,
                                                    .has_differentials = true});
    const scene::Model model = scene::build(document, plan);
    const auto draw = [&](int threads) {
      bench::keep(render::render(model.scene, plan, {.threads = threads}).statistics.nodes);
    };
    // The round that warms up also tells how long the loop must be to take as long as the picture.
    constexpr std::uint64_t kTrial = 200'000;
    const double picture_seconds = seconds_of([&] { draw(1); });
    const double trial_seconds = seconds_of([] { run_loop(1, kTrial); });
    const auto steps = static_cast<std::uint64_t>(kTrial * picture_seconds / trial_seconds);

    std::vector<double> loop_gains;
    std::vector<double> picture_gains;
    std::vector<double> shares;
    std::printf("round,picture_1_seconds,picture_2_seconds,loop_1_seconds,loop_2_seconds,share\n");
    for (int round = 0; round < kRounds; ++round) {
      // In the opposite order every second round, so that a machine whose speed drifts treats them alike.
      double picture[2];
      double loop[2];
      for (int i = 0; i < 4; ++i) {
        const int turn = round % 2 == 0 ? i : 3 - i;
        const int threads = 1 + turn / 2;
        if (turn % 2 == 0) {
          picture[threads - 1] = seconds_of([&] { draw(threads); });
        } else {
          loop[threads - 1] = seconds_of([&] { run_loop(threads, steps); });
        }
      }
      picture_gains.push_back(picture[0] / picture[1]);
      loop_gains.push_back(loop[0] / loop[1]);
      shares.push_back(picture_gains.back() / loop_gains.back());
      std::printf("%d,%.3f,%.3f,%.3f,%.3f,%.3f\n", round + 1, picture[0], picture[1], loop[0], loop[1],
                  shares.back());
      std::fflush(stdout);
    }
    const double share = bench::spread(shares).median;
    std::printf("# two threads: the picture gains %.3f, the loop %.3f; share %.3f%s\n",
                bench::spread(picture_gains).median, bench::spread(loop_gains).median, share,
                share >= kLeastShare ? "" : ": NOT AS CLAIMED (0.93)");
    return share >= kLeastShare ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "threads: %s\n", error.what());
    return 1;
  }
}
