// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "sweepkit/scene/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <thread>

#include "sweepkit/error.hpp"
#include "unprivileged.hpp"

namespace sweepkit::scene {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

class OutputFileTest : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("sweepkit_" + std::to_string(::getpid()) + info->name());
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string content(const std::string& name) const {
    std::ifstream stream(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void put(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_)) all.insert(entry.path().filename());
    return all;
  }
  std::string refusal(const fs::path& file) const {
    try {
      check_output(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
  const std::vector<std::byte> one_ = bytes_of("one");
  const std::vector<std::byte> two_ = bytes_of("two");
};

TEST_F(OutputFileTest, StagedFilesTakeTheirPlacesTogetherAndNoneBeforeThat) {
  put("a", "before");
  {
    StagedFiles files;
    files.add({folder_ / "a", one_});
    files.add({folder_ / "b", two_});
    EXPECT_EQ(content("a"), "before");
    EXPECT_FALSE(fs::exists(folder_ / "b"));
    files.put_in_place();
    EXPECT_EQ(content("a"), "one");
    EXPECT_EQ(content("b"), "two");
  }
  EXPECT_EQ(names(), (std::set<std::string>{"a", "b"}));
}

TEST_F(OutputFileTest, StagedFilesThatAreGivenUpLeaveNothing) {
  put("a", "before");
  {
    StagedFiles files;
    files.add({folder_ / "a", one_});
    files.add({"/dev/full", two_});
    EXPECT_THROW(files.put_in_place(), OutputError);
  }
  { StagedFiles().add({folder_ / "b", two_}); }
  EXPECT_EQ(names(), std::set<std::string>{"a"});
  EXPECT_EQ(content("a"), "before");
}

TEST_F(OutputFileTest, WritesSeveralFilesAndNothingElse) {
  write_files(std::vector<OutputFile>{{folder_ / "a", one_}, {folder_ / "b", two_}});
  EXPECT_EQ(names(), (std::set<std::string>{"a", "b"}));
  EXPECT_EQ(content("a"), "one");
  EXPECT_EQ(content("b"), "two");
}

TEST_F(OutputFileTest, ReplacesAFileAndKeepsItsMode) {
  put("a", "something longer");
  fs::permissions(folder_ / "a", fs::perms::owner_read | fs::perms::owner_write | fs::perms::owner_exec);
  write_files(std::vector<OutputFile>{{folder_ / "a", one_}});
  EXPECT_EQ(content("a"), "one");
  EXPECT_EQ(fs::status(folder_ / "a").permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::owner_exec);
}

TEST_F(OutputFileTest, NewFilesHaveTheModeOfTheUsersMask) {
  const mode_t before = ::umask(027);
  write_files(std::vector<OutputFile>{{folder_ / "a", one_}});
  ::umask(before);
  EXPECT_EQ(fs::status(folder_ / "a").permissions(), static_cast<fs::perms>(0640));
}

TEST_F(OutputFileTest, WritesThroughLinksToWhatTheyPointAt) {
  put("real", "old");
  fs::create_symlink("real", folder_ / "link");
  fs::create_symlink("link", folder_ / "link to link");
  fs::create_symlink("not there yet", folder_ / "dangling");
  write_files(std::vector<OutputFile>{{folder_ / "link to link", one_}, {folder_ / "dangling", two_}});
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "dangling"));
  EXPECT_EQ(content("real"), "one");
  EXPECT_EQ(content("not there yet"), "two");
}

TEST_F(OutputFileTest, FailingAtOneFileLeavesTheOthersAsTheyWere) {
  put("a", "old");
  EXPECT_THROW(write_files(std::vector<OutputFile>{{folder_ / "a", one_}, {folder_ / "none" / "b", two_}}),
               OutputError);
  EXPECT_THROW(write_files(std::vector<OutputFile>{{folder_ / "a", one_}, {folder_, two_}}), OutputError);
  EXPECT_EQ(content("a"), "old");
  EXPECT_EQ(names(), std::set<std::string>{"a"});
}

TEST_F(OutputFileTest, AFullDeviceIsAFailureAndStaysADevice) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  try {
    write_files(std::vector<OutputFile>{{folder_ / "a", one_}, {"/dev/full", two_}});
    FAIL() << "a full device took the bytes";
  } catch (const OutputError& error) {
    EXPECT_STREQ(error.what(), "/dev/full: cannot be written: No space left on device");
  }
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_EQ(names(), std::set<std::string>{});
}

TEST_F(OutputFileTest, DevicesAreWrittenToAsTheyAre) {
  write_files(std::vector<OutputFile>{{"/dev/null", one_}});
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(OutputFileTest, MoreFilesThanAnySceneHasImages) {
  std::vector<OutputFile> files;
  files.reserve(300);
  for (int i = 0; i < 300; ++i) files.push_back({folder_ / std::to_string(i), one_});
  write_files(files);
  EXPECT_EQ(names().size(), 300u);
}

TEST_F(OutputFileTest, ALongNameThatTheDiskAllowsIsWritten) {
  const std::string longest(255, 'n');
  write_files(std::vector<OutputFile>{{folder_ / longest, one_}});
  EXPECT_EQ(content(longest), "one");
}

// In a child process, since the handler of Ctrl-C ends it: a pipe without a reader's room holds the write up
// after the file beside is on the disk.
TEST_F(OutputFileTest, AbandoningAWriteRemovesWhatIsOnTheDisk) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  const auto run = [&] {
    ::signal(SIGALRM, [](int) {
      abandon_writes();
      ::_exit(130);
    });
    ::alarm(1);
    write_files(
        std::vector<OutputFile>{{folder_ / "a", one_}, {folder_ / "pipe", two_}});  // waits for a reader
    ::_exit(0);
  };
  EXPECT_EXIT(run(), testing::ExitedWithCode(130), "");
  EXPECT_EQ(names(), std::set<std::string>{"pipe"});
}

TEST_F(OutputFileTest, ThreadsWriteSideBySide) {
  constexpr int kThreads = 4;
  constexpr int kFiles = 100;
  std::vector<std::thread> threads;
  threads.reserve(kThreads);
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < kFiles; ++i) {
        const std::vector<std::byte> bytes = bytes_of(std::to_string(t * kFiles + i));
        write_files(std::vector<OutputFile>{{folder_ / std::to_string(t * kFiles + i), bytes}});
        // Failing does not touch what the others have on the way.
        EXPECT_THROW(
            write_files(std::vector<OutputFile>{{folder_ / "x", one_}, {folder_ / "none" / "b", two_}}),
            OutputError);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(names().size(), static_cast<std::size_t>(kThreads * kFiles));
  for (int i = 0; i < kThreads * kFiles; ++i) EXPECT_EQ(content(std::to_string(i)), std::to_string(i));
}

// The handler of Ctrl-C runs on one thread while the others go on writing: from then on none of them may
// bring a name to the disk.
TEST_F(OutputFileTest, AbandoningStopsTheWritesOfEveryThread) {
  const std::vector<std::byte> bytes(1 << 16);
  const auto run = [&] {
    ::signal(SIGALRM, [](int) {
      abandon_writes();
      ::usleep(20000);  // time in which another thread would do harm
      ::_exit(130);
    });
    ::ualarm(20000, 0);
    std::vector<std::thread> threads;
    threads.reserve(4);
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&, t] {
        while (true) write_files(std::vector<OutputFile>{{folder_ / std::to_string(t), bytes}});
      });
    }
    for (std::thread& thread : threads) thread.join();
  };
  for (int round = 0; round < 10; ++round) {
    EXPECT_EXIT(run(), testing::ExitedWithCode(130), "");
    for (const std::string& name : names()) {
      EXPECT_EQ(name.size(), 1u) << "left behind: " << name;
      EXPECT_EQ(fs::file_size(folder_ / name), bytes.size()) << name;
    }
  }
}

TEST_F(OutputFileTest, OutputsThatCannotBeAreRefusedBeforeAnyWork) {
  EXPECT_EQ(refusal(folder_ / "a.glb"), "");
  EXPECT_EQ(refusal("-"), "");
  EXPECT_EQ(refusal("/dev/null"), "");
  EXPECT_EQ(refusal(""), "names no file to write");
  EXPECT_EQ(refusal(folder_), folder_.string() + ": is a folder; name a file in it");
  EXPECT_EQ(refusal(folder_ / "none" / "a.glb"), (folder_ / "none" / "a.glb").string() +
                                                     ": there is no folder " + (folder_ / "none").string() +
                                                     "; make it first");
  put("file", "");
  EXPECT_NE(refusal(folder_ / "file" / "a.glb"), "");
  EXPECT_EQ(names(), std::set<std::string>{"file"}) << "nothing was made";
}

TEST_F(OutputFileTest, FoldersAndFilesThatMayNotBeWrittenAreRefused) {
  put("locked", "");
  const Unprivileged unprivileged(folder_);
  ASSERT_TRUE(unprivileged.is_sound());
  fs::permissions(folder_ / "locked", fs::perms::owner_read);
  EXPECT_EQ(refusal(folder_ / "locked"),
            (folder_ / "locked").string() + ": cannot be written: Permission denied");
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(refusal(folder_ / "a"),
            (folder_ / "a").string() + ": cannot be written: its folder: Permission denied");
  EXPECT_THROW(write_files(std::vector<OutputFile>{{folder_ / "a", one_}}), OutputError);
  fs::permissions(folder_, fs::perms::owner_all);
}

}  // namespace
}  // namespace sweepkit::scene
