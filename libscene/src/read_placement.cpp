// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "read_placement.hpp"

#include <algorithm>

namespace sweepkit::scene {
namespace {

constexpr Range kAngle{.low = -1e9, .high = 1e9, .unit = " degrees"};
constexpr Range kScale{.low = -1e9, .high = 1e9};

}  // namespace

Placement read_placement(ObjectReader& reader) {
  Placement placement;
  if (const auto node = reader.find("translate")) placement.translate = node->vector<3>(kCoordinate);
  if (const auto node = reader.find("rotate_deg")) placement.rotate_deg = node->vector<3>(kAngle);
  if (const auto node = reader.find("scale")) {
    placement.scale = node->is_number() ? glm::dvec3(node->number(kScale)) : node->vector<3>(kScale);
    const glm::dvec3 size = glm::abs(placement.scale);
    if (std::min({size.x, size.y, size.z}) < kExtent.low) {
      node->fail("needs factors other than 0, which would flatten the object");
    }
  }
  return placement;
}

std::vector<Placement> read_instances(ObjectReader& reader) {
  std::vector<Placement> instances;
  const std::optional<Node> list = reader.find("instances");
  if (!list) return instances;
  const auto* items = std::get_if<JsonValue::Array>(&list->value().data);
  if (items == nullptr) list->fail(std::string("needs an array, got ") + kind_name(list->value()));
  if (items->empty()) list->fail("needs at least one instance; leave it out for the object by itself");
  // One at a time and not by items(): there may be a million.
  instances.reserve(items->size());
  for (std::size_t i = 0; i < items->size(); ++i) {
    ObjectReader instance(Node((*items)[i], list->pointer() + "/" + std::to_string(i)));
    instances.push_back(read_placement(instance));
    instance.finish();
  }
  return instances;
}

}  // namespace sweepkit::scene
