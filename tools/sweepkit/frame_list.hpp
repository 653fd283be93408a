// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace sweepkit::tools {

inline constexpr int kLastFrame = 999999;

/// The frames of --frames, in the order they are drawn.
struct FrameList {
  std::vector<int> numbers;
  /// Frames of a full turn, where nothing else is said: the largest number that is written, so 120 in
  /// 1-120:2, and one more where the list begins with frame 0.
  int count_in_turn = 1;
};

/// "7", "1-120", "1-120:2" (every other), or several of them apart by commas. Throws InputError naming
/// --frames: anything else, a number over kLastFrame, a range that runs backwards, a frame twice.
FrameList parse_frames(const std::string& text);

/// The files of frames: -o turn_{frame}.png, {frame:04} with so many digits. Without a width a number has as
/// many digits as the largest, so that names sort as frames do. Throws InputError naming -o: standard output,
/// another name in braces, a brace without its other, one name for several frames.
std::vector<std::string> name_frames(const std::string& pattern, const FrameList& frames);

}  // namespace sweepkit::tools
