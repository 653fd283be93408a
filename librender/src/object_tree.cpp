// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on Wald, "On fast construction of SAH-based bounding volume hierarchies" (2007): a node's objects are
// sorted into bins by the middles of their boxes along the longest axis, and parted where the areas of the
// two sides' boxes, weighed by their numbers, are least. It takes the place of the global grid of
// [Akdemir98, 3.3], which it departs from because a grid's voxels are of one size and a scene's objects are
// not: a floor fills every voxel, and a thousand screws one.

#include "object_tree.hpp"

#include <cmath>

namespace sweepkit::render {
namespace {

constexpr std::size_t kBins = 16;

double half_area(const Box& box) {
  const glm::dvec3 size = box.high - box.low;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

void add(Box& box, const Box& other) {
  box.low = glm::min(box.low, other.low);
  box.high = glm::max(box.high, other.high);
}

// float32 outside of the number: conversion rounds to nearest.
float below(double value) {
  const auto rounded = static_cast<float>(value);
  return static_cast<double>(rounded) > value ? std::nextafter(rounded, -HUGE_VALF) : rounded;
}

float above(double value) {
  const auto rounded = static_cast<float>(value);
  return static_cast<double>(rounded) < value ? std::nextafter(rounded, HUGE_VALF) : rounded;
}

}  // namespace

struct ObjectTree::Builder {
  std::span<const Box> boxes;
  std::vector<std::uint32_t>& objects;
  ObjectTree& tree;

  double middle(std::uint32_t object, int axis) const {
    return boxes[object].low[axis] + boxes[object].high[axis];
  }

  // One past the last object of the first part.
  std::size_t halve(std::size_t first, std::size_t end, int axis) const {
    const std::size_t half = first + (end - first) / 2;
    const auto at = [&](std::size_t i) { return objects.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(half), at(end), [&](std::uint32_t a, std::uint32_t b) {
      const double ma = middle(a, axis);
      const double mb = middle(b, axis);
      return ma != mb ? ma < mb : a < b;
    });
    return half;
  }

  std::size_t split(std::size_t first, std::size_t end, int depth) const {
    Box middles;
    for (std::size_t i = first; i < end; ++i) {
      const Box& box = boxes[objects[i]];
      middles.add(box.low + box.high);
    }
    const glm::dvec3 size = middles.high - middles.low;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const double low = middles.low[axis];
    const double bins_per_metre = static_cast<double>(kBins) / size[axis];
    if (depth >= kMostHeuristicSplits || end - first == 2 || !(bins_per_metre < kNoEnd))
      return halve(first, end, axis);
    const auto bin_of = [&](std::uint32_t object) {
      return std::min(static_cast<std::size_t>((middle(object, axis) - low) * bins_per_metre), kBins - 1);
    };
    struct Bin {
      Box box;
      double count = 0;
    };
    std::array<Bin, kBins> bins;
    for (std::size_t i = first; i < end; ++i) {
      Bin& bin = bins[bin_of(objects[i])];
      add(bin.box, boxes[objects[i]]);
      bin.count += 1;
    }
    // cost[k]: of bins k.. together.
    std::array<double, kBins> cost{};
    Bin sum;
    for (std::size_t k = kBins; k-- > 1;) {
      add(sum.box, bins[k].box);
      sum.count += bins[k].count;
      cost[k] = sum.count > 0 ? sum.count * half_area(sum.box) : 0;
    }
    sum = {};
    std::size_t best = 1;
    double least = kNoEnd;
    for (std::size_t k = 1; k < kBins; ++k) {
      add(sum.box, bins[k - 1].box);
      sum.count += bins[k - 1].count;
      const double total = sum.count * half_area(sum.box) + cost[k];
      // The lowest bin and the highest have an object each, so no part is empty.
      if (total < least) {
        least = total;
        best = k;
      }
    }
    const auto begin = objects.begin();
    const auto parted =
        std::partition(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end),
                       [&](std::uint32_t object) { return bin_of(object) < best; });
    return static_cast<std::size_t>(parted - begin);
  }

  // The subtree over objects first..end-1, whose end - first - 1 nodes lie from `node` on; its box.
  Box build(std::size_t first, std::size_t end, std::size_t node, int depth, std::int32_t& child) const {
    if (end - first == 1) {
      child = ~static_cast<std::int32_t>(objects[first]);
      return boxes[objects[first]];
    }
    child = static_cast<std::int32_t>(node);
    const std::size_t half = split(first, end, depth);
    std::array<std::int32_t, 2> children{};
    const std::array<Box, 2> sides = {build(first, half, node + 1, depth + 1, children[0]),
                                      build(half, end, node + (half - first), depth + 1, children[1])};
    Node& written = tree.nodes_[node];
    written.children = children;
    Box whole;
    for (std::size_t side = 0; side < 2; ++side) {
      add(whole, sides[side]);
      for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        written.low[side][a] = below(sides[side].low[axis] - tree.middle_[axis]);
        written.high[side][a] = above(sides[side].high[axis] - tree.middle_[axis]);
      }
    }
    return whole;
  }
};

ObjectTree::ObjectTree(std::span<const Box> boxes, std::vector<std::uint32_t> objects, double rounding,
                       double reach)
    : is_empty_(objects.empty()), rounding_(rounding), reach_(reach) {
  if (is_empty_) return;
  Box all;
  for (const std::uint32_t object : objects) add(all, boxes[object]);
  middle_ = 0.5 * (all.low + all.high);
  nodes_.resize(objects.size() - 1);
  Builder{boxes, objects, *this}.build(0, objects.size(), 0, 0, root_);
}

}  // namespace sweepkit::render
