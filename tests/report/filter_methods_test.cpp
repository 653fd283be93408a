// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "filter_methods.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "module_file.hpp"
#include "plane_view.hpp"

namespace sweepkit::report {
namespace {

PlaneTexture grey_texture() {
  return {64, std::vector<float>(64 * 64, 0.25f)};
}

std::set<std::string> names_of(const std::vector<FilterMethod>& methods) {
  std::set<std::string> names;
  for (const FilterMethod& method : methods) names.insert(method.name);
  return names;
}

TEST(FilterMethods, HaveEveryFilterAndThePeerOnlyWhereItIs) {
  for (const bool is_quick : {false, true}) {
    const std::set<std::string> own = names_of(filter_methods(is_quick, false));
    EXPECT_EQ(own, std::set<std::string>(texmap::kFilterNames.begin(), texmap::kFilterNames.end()));
    EXPECT_GE(names_of(filter_methods(is_quick, true)).size(), own.size() + 2);
  }
}

TEST(FilterMethods, GiveTheGreyOfAGreyTexture) {
  const PlaneView view(16, 35);
  const texmap::ImageTexture texture{to_image(grey_texture())};
  texmap::TileCache cache;
  texmap::FilterThread thread(cache);
  std::uint32_t id = 0;
  for (const FilterMethod& method : filter_methods(false, false)) {
    const auto& own = std::get<OwnLookup>(method.lookup);
    const texmap::TextureSampler sampler(texture, own.filter, cache, id++);
    for (const PlanePixel& pixel : plane_pixels(view)) {
      // 16-bit texels, sums of float.
      ASSERT_NEAR(look_up(sampler, own, pixel.footprint, thread), 0.25, 1e-5)
          << method.name << ' ' << method.setting;
    }
  }
}

TEST(FilterMethods, OfOneSampleEachAreTheFilterItself) {
  const PlaneView view(16, 35);
  const texmap::ImageTexture texture{to_image(checker_texture(64))};
  texmap::TileCache cache;
  texmap::FilterThread thread(cache);
  const texmap::TextureSampler sampler(texture, texmap::Filter::kBilinear, cache, 0);
  for (const PlanePixel& pixel : plane_pixels(view)) {
    ASSERT_EQ(look_up(sampler, {texmap::Filter::kBilinear}, pixel.footprint, thread),
              sampler.sample(pixel.footprint, thread).r);
  }
}

TEST(FilterMethods, TakeTheMeanOfSamplesSpreadOverThePixel) {
  const texmap::ImageTexture texture{to_image(checker_texture(64))};
  texmap::TileCache cache;
  texmap::FilterThread thread(cache);
  const texmap::TextureSampler sampler(texture, texmap::Filter::kPoint, cache, 0);
  // The pixel is half on one check and half on the other: of two by two samples two are on each.
  const texmap::Footprint footprint{{0.5, 0.25}, {0.1, 0}, {0, 0.1}};
  EXPECT_NEAR(look_up(sampler, {texmap::Filter::kPoint, 2}, footprint, thread), (0.9 + 0.05) / 2, 1e-4);
}

class Peer : public testing::Test {
 protected:
  void SetUp() override {
    std::string reason;
    peer_ = texture_peer(reason);
    ASSERT_NE(peer_, nullptr) << reason;
  }
  const TexturePeer* peer_ = nullptr;
};

TEST_F(Peer, GivesTheGreyOfAGreyTextureHoweverItIsAsked) {
  const PlaneView view(16, 35);
  std::vector<texmap::Footprint> footprints;
  for (const PlanePixel& pixel : plane_pixels(view)) footprints.push_back(pixel.footprint);
  void* handle = nullptr;
  ASSERT_EQ(peer_->open(grey_texture().texels.data(), 64, handle), "");
  for (const FilterMethod& method : filter_methods(false, true)) {
    const auto* options = std::get_if<PeerOptions>(&method.lookup);
    if (options == nullptr) continue;
    std::vector<float> values(footprints.size());
    peer_->sample(handle, *options, footprints.data(), footprints.size(), values.data());
    for (const float value : values) ASSERT_NEAR(value, 0.25, 1e-4) << method.name << method.setting;
  }
  peer_->close(handle);
}

TEST_F(Peer, SeesTheTextureTheSameWayUpAsWeDo) {
  PlaneTexture texture = grey_texture();
  // White where u < 1/2 and v > 1/2: the upper left quarter.
  for (std::size_t y = 0; y < 32; ++y) {
    for (std::size_t x = 0; x < 32; ++x) texture.texels[64 * y + x] = 1;
  }
  const texmap::ImageTexture own{to_image(texture)};
  texmap::TileCache cache;
  texmap::FilterThread thread(cache);
  const texmap::TextureSampler sampler(own, texmap::Filter::kEwa, cache, 0);
  void* handle = nullptr;
  ASSERT_EQ(peer_->open(texture.texels.data(), 64, handle), "");
  for (const glm::dvec2& uv : {glm::dvec2(0.25, 0.75), glm::dvec2(0.75, 0.75), glm::dvec2(0.25, 0.25)}) {
    const texmap::Footprint footprint{uv, {1.0 / 64, 0}, {0, -1.0 / 64}};
    float value = 0;
    peer_->sample(handle, {}, &footprint, 1, &value);
    EXPECT_NEAR(value, look_up(sampler, {texmap::Filter::kEwa}, footprint, thread), 1e-3);
  }
  peer_->close(handle);
}

TEST_F(Peer, SaysWhatIsWrongWhereThereIsNoFolderForItsPyramid) {
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  setenv("TMPDIR", "/no/such/folder", 1);
  void* handle = nullptr;
  const std::string problem = peer_->open(grey_texture().texels.data(), 64, handle);
  before != nullptr ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
  EXPECT_NE(problem.find("TMPDIR"), std::string::npos) << problem;
  EXPECT_EQ(handle, nullptr);
}

TEST(ModuleFile, ThatIsMissingIsNamedWithTheReason) {
  std::string tried;
  EXPECT_EQ(texmap::module_symbol("sweepkit-no-such-module.so", "anything", tried), nullptr);
  EXPECT_NE(tried.find("sweepkit-no-such-module.so"), std::string::npos) << tried;
}

}  // namespace
}  // namespace sweepkit::report
