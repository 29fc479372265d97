// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/report/fingerprint.h"

#include <fmt/format.h>

#include <cmath>

namespace dewpoint::experiment {
namespace {

constexpr std::uint64_t kFnvPrime = 1099511628211ULL;

/// Of a value that is not finite; nothing of one that is.
std::string_view nameOf(double value) {
  if (std::isnan(value)) {
    return "none";
  }
  if (std::isinf(value)) {
    return value > 0.0 ? "inf" : "-inf";
  }
  return {};
}

} // namespace

void Fingerprint::add(double value, double step) {
  const std::string_view name = nameOf(value);
  add(name.empty() ? fmt::format("{}", std::llround(value / step)) : std::string(name));
}

void Fingerprint::addDigits(double value, int digits) {
  const std::string_view name = nameOf(value);
  // Adding 0 makes 0 of -0.
  add(name.empty() ? fmt::format("{:.{}e}", value + 0.0, digits - 1) : std::string(name));
}

void Fingerprint::add(std::string_view text) {
  const auto addByte = [&](char byte) {
    state_ = (state_ ^ static_cast<unsigned char>(byte)) * kFnvPrime;
  };
  for (const char byte : text) {
    addByte(byte);
  }
  addByte(';'); // "1", "2" differs from "12"
}

std::string Fingerprint::text() const {
  constexpr int kHalf = 32;
  return fmt::format("{:08x}", static_cast<std::uint32_t>((state_ >> kHalf) ^ state_));
}

} // namespace dewpoint::experiment
