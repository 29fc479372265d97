// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <vector>

namespace dewpoint::tests {

/// An include that a file in that folder may not have.
struct PlantedViolation {
  std::string file; ///< relative to the repository; it need not exist
  std::string include;
};

/// At least one for each room with sources, so that no rule is kept only because nothing asks for
/// it.
const std::vector<PlantedViolation>& plantedViolations();

} // namespace dewpoint::tests
