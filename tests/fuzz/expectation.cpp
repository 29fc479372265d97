// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/expectation.h"

#include "core/base/one_line.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>

namespace dewpoint::tests {
namespace {

/// Of a sentence: file, field and detail are not longer each.
constexpr std::size_t kMostSentenceBytes = 16'000;

} // namespace

void expect(bool condition, const char* what) {
  if (!condition) {
    fmt::print(stderr, "the reader broke its promise: {}\n", what);
    std::abort();
  }
}

void expectPlain(const Error& error) {
  const std::string text = base::errorSentence(error);
  if (error.file.empty() || text.size() > kMostSentenceBytes ||
      text.find_first_of("\n\r") != text.npos ||
      (text.size() < 4000 && base::toSingleLine(text) != text)) {
    fmt::print(stderr, "not one plain sentence with a file: {}\n", text);
    std::abort();
  }
}

} // namespace dewpoint::tests
