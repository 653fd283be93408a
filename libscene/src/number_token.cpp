// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "number_token.hpp"

#include <charconv>
#include <limits>

namespace sweepkit::scene {
namespace {

// from_chars says the same of a number too large and one too small for a double; the power of ten of the
// first digit that is not 0 tells them apart.
bool is_large(std::string_view token) {
  const std::size_t e = token.find_first_of("eE");
  const std::string_view mantissa = token.substr(0, e);
  const std::size_t dot = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return false;
  double power = static_cast<double>(dot) - static_cast<double>(first);
  if (e != std::string_view::npos) {
    std::string_view exponent = token.substr(e + 1);
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    long value = 0;
    if (std::from_chars(exponent.data(), exponent.data() + exponent.size(), value).ec != std::errc()) {
      return !exponent.starts_with('-');  // an exponent beyond any long outweighs any mantissa
    }
    power += static_cast<double>(value);
  }
  return power > 0;
}

}  // namespace

std::optional<double> take_number(std::string_view& text) {
  const bool is_negative = text.starts_with('-');
  const std::string_view digits = text.substr(is_negative || text.starts_with('+') ? 1 : 0);
  // What begins otherwise is a second sign, "nan" or "inf".
  if (digits.empty() || std::string_view(".0123456789").find(digits.front()) == std::string_view::npos) {
    return std::nullopt;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument) return std::nullopt;
  const std::string_view token = digits.substr(0, static_cast<std::size_t>(end - digits.data()));
  if (error == std::errc::result_out_of_range) {
    value = is_large(token) ? std::numeric_limits<double>::infinity() : 0;
  }
  text = digits.substr(token.size());
  return is_negative ? -value : value;
}

}  // namespace sweepkit::scene
