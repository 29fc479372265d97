// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/numbered_files.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace dewpoint::capture {
namespace {

/// What is certain to fit into 64 bits, and into the digits of a double where it matters.
constexpr std::size_t kMostDigits = 18;

bool isDecimalDigit(char c) {
  return c >= '0' && c <= '9';
}

std::size_t digitsAtEnd(std::string_view name) {
  const auto last = std::find_if_not(name.rbegin(), name.rend(), isDecimalDigit);
  return static_cast<std::size_t>(last - name.rbegin());
}

} // namespace

std::optional<std::int64_t> trailingNumber(std::string_view name) {
  const std::size_t digits = digitsAtEnd(name);
  if (digits == 0 || digits > kMostDigits) {
    return std::nullopt;
  }
  std::int64_t number = 0;
  std::from_chars(name.data() + name.size() - digits, name.data() + name.size(), number);
  return number;
}

std::vector<std::int64_t> sequenceNumbersOf(const std::vector<std::string>& files) {
  std::vector<std::int64_t> numbers;
  std::string beginning;
  for (const std::string& file : files) {
    const std::string name = std::filesystem::path(file).stem().string();
    const auto number = trailingNumber(name);
    const std::string before = name.substr(0, name.size() - digitsAtEnd(name));
    if (!number || (!numbers.empty() && (before != beginning || *number <= numbers.back()))) {
      return {};
    }
    beginning = before;
    numbers.push_back(*number);
  }
  if (numbers.size() < 3) {
    return {};
  }
  std::int64_t step = numbers[1] - numbers[0];
  for (std::size_t k = 2; k < numbers.size(); ++k) {
    step = std::min(step, numbers[k] - numbers[k - 1]);
  }
  std::vector<std::int64_t> result;
  for (const std::int64_t number : numbers) {
    const std::int64_t way = number - numbers.front();
    if (way % step != 0) {
      return {};
    }
    result.push_back(way / step);
  }
  const std::int64_t gaps = result.back() + 1 - std::ssize(result);
  return gaps > 0 && gaps < std::ssize(result) ? result : std::vector<std::int64_t>();
}

} // namespace dewpoint::capture
