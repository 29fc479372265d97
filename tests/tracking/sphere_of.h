// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/tracker.h"

#include <cstddef>
#include <variant>

namespace dewpoint::tests {

/// What is believed of a track that is a sphere; throws when it is something else.
inline SphereEstimate sphereOf(const Tracker& tracker, std::size_t track = 0) {
  return std::get<SphereEstimate>(tracker.estimate(track));
}

} // namespace dewpoint::tests
