// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/tracker.h"

#include "core/tracking/barrera_tracker.h"

#include <algorithm>
#include <cmath>

namespace dewpoint {
namespace {

/// The method's first parameter that `parameters` does not have; empty if it has them all.
std::string missingParameter(const std::string& method, const ParameterValues& parameters) {
  const auto declared = parameters.declarations();
  for (const auto& needed : methodParameters(method)) {
    if (std::ranges::find(declared, needed.key, &ParameterDeclaration::key) == declared.end()) {
      return needed.key;
    }
  }
  return {};
}

} // namespace

double TargetEstimate::spread() const {
  return std::sqrt(covariance.trace());
}

Result<std::unique_ptr<Tracker>> makeTracker(const std::string& method,
                                             const ParameterValues& parameters,
                                             const CameraRig& rig, const Target& target) {
  if (method != "barrera") {
    std::string known;
    for (const auto& name : methodNames()) {
      known += (known.empty() ? "" : ", ") + name;
    }
    return failure(ErrorCode::NotFound, "", "method", "\"" + method + "\"; known: " + known);
  }
  const std::string missing = missingParameter(method, parameters);
  if (!missing.empty()) {
    return failure(ErrorCode::MissingKey, "", missing, "method " + method + " needs it");
  }
  return std::make_unique<BarreraTracker>(parameters, rig, target);
}

} // namespace dewpoint
