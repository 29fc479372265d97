// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/pink_target.h"

#include "core/simulation/scene/scene.h"

namespace dewpoint::experiment::scenarios {

Target pinkTarget(const std::string& name, double radius) {
  const SceneBall pink;
  return {name, radius,
          ColorRange{pink.hueMin, pink.hueMax, pink.saturationMin, pink.saturationMax,
                     pink.intensityMin, pink.intensityMax}};
}

} // namespace dewpoint::experiment::scenarios
