// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "gltf_motion.hpp"

#include <map>

#include "cos_sin_deg.hpp"

namespace sweepkit::scene {
namespace {

constexpr const char* kLinear = "LINEAR";

void add_channel(tinygltf::Animation& animation, int sampler, int node, const char* path) {
  tinygltf::AnimationChannel channel;
  channel.sampler = sampler;
  channel.target_node = node;
  channel.target_path = path;
  animation.channels.push_back(std::move(channel));
}

int add_sampler(tinygltf::Animation& animation, int input, int output) {
  tinygltf::AnimationSampler sampler;
  sampler.input = input;
  sampler.output = output;
  sampler.interpolation = kLinear;
  animation.samplers.push_back(std::move(sampler));
  return static_cast<int>(animation.samplers.size()) - 1;
}

}  // namespace

std::array<glm::vec4, 13> turn_keys() {
  std::array<glm::vec4, 13> keys;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const glm::dvec2 half = cos_sin_deg(15.0 * static_cast<double>(k));
    keys[k] = {0.0f, static_cast<float>(half.y), 0.0f, static_cast<float>(half.x)};
  }
  return keys;
}

void add_turntable(tinygltf::Model& model, GltfBuffer& buffer, int node, double seconds) {
  const std::array<glm::vec4, 13> keys = turn_keys();
  std::array<float, keys.size()> times;
  for (std::size_t k = 0; k < keys.size(); ++k)
    times[k] = static_cast<float>(seconds * static_cast<double>(k) / static_cast<double>(keys.size() - 1));
  tinygltf::Animation animation;
  animation.name = "turntable";
  const int sampler = add_sampler(animation, buffer.add_key_times(times), buffer.add_rotations(keys));
  add_channel(animation, sampler, node, "rotation");
  model.animations.push_back(std::move(animation));
}

void add_targets(tinygltf::Primitive& primitive, GltfBuffer& buffer, const Growth& growth) {
  for (const Growth::State& state : growth.states) {
    primitive.targets.push_back(
        {{"POSITION", buffer.add_positions(state.moved)}, {"NORMAL", buffer.add_vertices(state.turned)}});
  }
}

void add_growing(tinygltf::Model& model, GltfBuffer& buffer, const std::vector<GrowingNode>& nodes,
                 double seconds) {
  tinygltf::Animation animation;
  animation.name = "grow";
  std::map<const Growth*, int> samplers;
  for (const GrowingNode& node : nodes) {
    const auto [sampler, is_new] = samplers.try_emplace(node.growth);
    if (is_new) {
      const std::size_t states = node.growth->states.size();
      std::vector<float> times;
      std::vector<float> weights(states * (states + 1), 0.0f);  // at the last key all are 0: the mesh itself
      for (std::size_t k = 0; k < states; ++k) {
        times.push_back(static_cast<float>(seconds * node.growth->states[k].time));
        weights[k * states + k] = 1;
      }
      times.push_back(static_cast<float>(seconds));
      const int input = buffer.add_key_times(times);
      sampler->second = add_sampler(animation, input, buffer.add_weights(weights));
    }
    add_channel(animation, sampler->second, node.node, "weights");
  }
  model.animations.push_back(std::move(animation));
}

}  // namespace sweepkit::scene
