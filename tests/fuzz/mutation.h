// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::tests {

/// Makes inputs of a fuzzer out of those of a corpus: changed bytes, parts that go, come twice or
/// from another file, and words and numbers that readers may stumble over. The same seed gives the
/// same inputs on every machine.
class Mutation {
public:
  /// `corpus` is kept by reference and holds at least one input, which may be empty.
  Mutation(const std::vector<std::string>& corpus, std::uint64_t seed);

  /// The next input, at most 64 kB.
  std::string next();

private:
  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }
  void changeOnce(std::string& text);
  void replaceNumber(std::string& text);
  void insertPart(std::string& text);

  const std::vector<std::string>& corpus_;
  std::mt19937_64 random_;
};

} // namespace dewpoint::tests
