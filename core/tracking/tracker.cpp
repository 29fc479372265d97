// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/tracker.h"

#include "core/tracking/barrera/barrera_tracker.h"
#include "core/tracking/barrera/dynamics_tracker.h"

#include <cmath>

namespace dewpoint::tracking {
double TargetEstimate::spread() const {
  return std::sqrt(covariance.trace());
}

Result<std::unique_ptr<Tracker>> makeTracker(const std::string& method,
                                             const ParameterValues& parameters,
                                             const CameraRig& rig, const Target& target) {
  if (method != "barrera" && method != "dynamics") {
    std::string known;
    for (const auto& name : methodNames()) {
      known += (known.empty() ? "" : ", ") + name;
    }
    return failure(ErrorCode::NotFound, "", "method", "\"" + method + "\"; known: " + known);
  }
  if (const auto checked = checkParameters(method, parameters); !checked) {
    return tl::make_unexpected(checked.error());
  }
  if (method == "dynamics") {
    return std::make_unique<DynamicsTracker>(parameters, rig, target);
  }
  return std::make_unique<BarreraTracker>(parameters, rig, target);
}

} // namespace dewpoint::tracking
