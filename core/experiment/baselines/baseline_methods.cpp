// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/baseline_methods.h"

#include "core/experiment/baselines/baseline_camshift.h"
#include "core/experiment/baselines/baseline_csrt.h"
#include "core/experiment/baselines/baseline_tracker.h"
#include "core/experiment/baselines/rig_start.h"
#include "core/experiment/baselines/smoothed_method.h"
#include "core/tracking/catalog/method_catalog.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace dewpoint::experiment {
namespace {

template <class Follower> std::unique_ptr<CameraFollower> makeFollowerByName() {
  return std::make_unique<Follower>();
}

struct Baseline {
  const char* name;
  BaselineSetup setup;
};

const std::array<Baseline, 4>& baselines() {
  static const std::array<Baseline, 4> all{{
      {"triangulation", {nullptr, false}},
      {"triangulation-kalman", {nullptr, true}},
      {"camshift", {makeFollowerByName<CamShiftFollower>, false}},
      {"csrt", {makeFollowerByName<CsrtFollower>, false}},
  }};
  return all;
}

/// Methods that find nothing but by particles near it: they start in what the cameras see.
constexpr std::array<std::string_view, 2> kStartFromRig{"barrera", "dynamics"};

StartVolume startOf(const std::string& method, const ScenarioRun& run) {
  return std::ranges::find(kStartFromRig, method) != kStartFromRig.end()
             ? startVolumeFromRig(run)
             : StartVolume{run.startCenter, run.startHalfSize};
}

/// The method's defaults with what the run says of its start and sensing.
Result<ParameterValues> parametersFor(const std::string& method, const ScenarioRun& run) {
  const StartVolume start = startOf(method, run);
  std::map<std::string, double> told;
  const std::array<std::string, 3> axes{"x", "y", "z"};
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    told["start_" + axes[axis]] = start.center[k];
    told["start_half_" + axes[axis]] = start.halfSize[k];
  }
  if (run.isSensingExact) {
    told["calibration_error"] = 0.0;
    told["time_error"] = 0.0;
    told["delay_spread"] = 0.0;
  }
  ParameterValues values(methodParameters(method));
  for (const auto& [key, value] : told) {
    const auto known = values.declarations();
    if (std::ranges::find(known, key, &ParameterDeclaration::key) == known.end()) {
      continue; // a method may do without it
    }
    if (const auto set = values.set(key, value); !set) {
      return tl::make_unexpected(set.error());
    }
  }
  return values;
}

} // namespace

std::vector<std::string> suiteMethods() {
  std::vector<std::string> names = methodNames(TargetSource::Color); // the default first
  names.insert(names.begin() + 1, kSmoothedMethod);
  for (const Baseline& baseline : baselines()) {
    names.emplace_back(baseline.name);
  }
  return names;
}

Result<std::unique_ptr<Tracker>> makeSuiteTracker(const std::string& method,
                                                  const ScenarioRun& run) {
  for (const Baseline& baseline : baselines()) {
    if (method == baseline.name) {
      return std::make_unique<BaselineTracker>(baseline.setup, run.rig, run.targets,
                                               StartVolume{run.startCenter, run.startHalfSize});
    }
  }
  const std::string tracked =
      method == kSmoothedMethod ? std::string(methods().front().name) : method;
  const auto parameters = parametersFor(tracked, run);
  if (!parameters) {
    return tl::make_unexpected(parameters.error());
  }
  return makeTracker(tracked, *parameters, run.rig, run.targets);
}

} // namespace dewpoint::experiment
