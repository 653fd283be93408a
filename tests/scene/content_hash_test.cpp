// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "sweepkit/error.hpp"
#include "sweepkit/scene/document.hpp"
#include "unprivileged.hpp"

namespace sweepkit::scene {
namespace {

const std::string kScene = R"({"sweepkit": 1, "objects": [{"name": "p", "plane": {"size": [1, 2]}}]})";

std::string hash_of(const std::string& text, std::string_view more = "") {
  return SceneFile(text, "folder/test.json").content_hash(more);
}

TEST(ContentHash, DoesNotSeeSpacingCommentsOrTheScenesName) {
  EXPECT_EQ(hash_of(kScene).size(), 32u);
  EXPECT_EQ(hash_of(kScene), hash_of("{ // a plane\n\"sweepkit\": 1.0,\n\"objects\": "
                                     "[{\"name\":\"p\",\"plane\":{\"size\":[1, 2e0]}}]}"));
  EXPECT_EQ(hash_of(kScene), SceneFile(kScene, "elsewhere/other.json").content_hash(""));
}

TEST(ContentHash, SeesEveryValueAndKeyAndWhatComesWithThem) {
  const std::string plain = hash_of(kScene);
  for (const char* other : {R"({"sweepkit": 1, "objects": [{"name": "p", "plane": {"size": [1, 3]}}]})",
                            R"({"sweepkit": 1, "objects": [{"name": "q", "plane": {"size": [1, 2]}}]})",
                            R"({"sweepkit": 1, "objects": [{"nam": "p", "plane": {"size": [1, 2]}}]})",
                            R"({"sweepkit": 1, "objects": [{"name": "p", "plane": {"size": [[1, 2]]}}]})",
                            R"({"sweepkit": 1, "objects": [{"name": "p", "plane": {"size": ["1", 2]}}]})",
                            R"({"sweepkit": true, "objects": [{"name": "p", "plane": {"size": [1, 2]}}]})",
                            R"({"sweepkit": null, "objects": [{"name": "p", "plane": {"size": [1, 2]}}]})"}) {
    EXPECT_NE(hash_of(other), plain) << other;
  }
  EXPECT_NE(hash_of(kScene, "--filter=point"), plain);
  EXPECT_NE(hash_of(R"(["ab", "c"])"), hash_of(R"(["a", "bc"])"));
  SceneFile set(kScene, "test.json");
  set.set({"/objects/0/plane/size/1", "3"});
  EXPECT_EQ(set.content_hash(""),
            hash_of(R"({"sweepkit": 1, "objects": [{"name": "p", "plane": {"size": [1, 3]}}]})"));
}

class NamedFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) / ("sweepkit_hash_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void put(const std::string& text) const { std::ofstream(folder_ / "a.csv") << text; }
  std::string hash() const {
    return SceneFile(R"({"objects": [{"csv": "a.csv"}, {"again": "a.csv"}]})", folder_ / "s.json")
        .content_hash("");
  }

  std::filesystem::path folder_;
};

TEST_F(NamedFile, CountsByItsBytes) {
  const std::string without = hash();
  put("0,0\n1,1\n");
  const std::string with = hash();
  EXPECT_NE(with, without);
  put("0,0\n1,2\n");
  EXPECT_NE(hash(), with);
  put("0,0\n1,1\n");
  EXPECT_EQ(hash(), with);
}

TEST_F(NamedFile, ThatCannotBeReadIsRefused) {
  put("0,0\n");
  std::filesystem::permissions(folder_ / "a.csv", std::filesystem::perms::none);
  const Unprivileged nobody(folder_);
  ASSERT_TRUE(nobody.is_sound());
  EXPECT_THROW(hash(), InputError);
}

}  // namespace
}  // namespace sweepkit::scene
