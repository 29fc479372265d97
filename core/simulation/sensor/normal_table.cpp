// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sensor/normal_table.h"

#include "core/base/random.h"

#include <algorithm>
#include <cstdint>

namespace dewpoint::simulation {

const std::vector<float>& standardNormalNumbers() {
  static const std::vector<float> table = [] {
    std::vector<float> values(kNormalCount);
    const RandomStream stream(0, 0, 0, RandomPurpose::Noise);
    for (std::size_t i = 0; i < kNormalCount; i += 4) {
      const auto four = stream.normal4(static_cast<std::uint32_t>(i / 4), 1);
      std::ranges::transform(four, values.begin() + static_cast<std::ptrdiff_t>(i),
                             [](double value) { return static_cast<float>(value); });
    }
    return values;
  }();
  return table;
}

} // namespace dewpoint::simulation
