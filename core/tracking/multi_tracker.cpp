// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/multi_tracker.h"

#include "core/tracking/boxes/box_targets.h"
#include "core/tracking/dewpoint/dewpoint_tracker.h"
#include "core/tracking/independent_trackers.h"
#include "core/tracking/people/people_targets.h"

#include <utility>

namespace dewpoint::tracking {

Result<std::unique_ptr<MultiTracker>> makeMultiTracker(const std::string& method,
                                                       const ParameterValues& parameters,
                                                       const CameraRig& rig,
                                                       const std::vector<Target>& targets) {
  if (method == "dewpoint") {
    if (const auto checked = checkParameters(method, parameters); !checked) {
      return tl::make_unexpected(checked.error());
    }
    return std::make_unique<DewpointTracker>(parameters, rig, targets);
  }
  if (methodFamily(method) == MethodFamily::Boxes) {
    if (const auto checked = checkParameters(method, parameters); !checked) {
      return tl::make_unexpected(checked.error());
    }
    return std::make_unique<BoxTargets>(method, parameters, targets);
  }
  if (methodFamily(method) == MethodFamily::People) {
    return makePeopleTracker(method, parameters, rig)
        .map([](std::unique_ptr<PeopleTracker> tracker) -> std::unique_ptr<MultiTracker> {
          return std::make_unique<PeopleTargets>(std::move(tracker));
        });
  }
  std::vector<std::unique_ptr<Tracker>> trackers;
  for (const Target& target : targets) {
    auto tracker = makeTracker(method, parameters, rig, target);
    if (!tracker) {
      return tl::make_unexpected(tracker.error());
    }
    trackers.push_back(std::move(*tracker));
  }
  return std::make_unique<IndependentTrackers>(std::move(trackers));
}

} // namespace dewpoint::tracking
