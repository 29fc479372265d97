// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <string_view>

namespace dewpoint::tracking {

/// Weighted points that represent the volume of a person's body. `points` has rows of x, y, z in
/// meters, world frame. The weights are linear and sum to 1.
struct BodyCloud {
  Eigen::ArrayXXd points;
  Eigen::ArrayXd weights;
};

/// State of one camera's background model.
struct PeopleCameraState {
  double learningProgress = 0.0;   ///< progress of the learning phase, 0 to 1
  double foregroundFraction = 0.0; ///< fraction of the image that is foreground, 0 to 1
  /// True if there is an image, learning is complete, and the image is not entirely foreground.
  bool isUsable = false;
};

/// Returns the name of a person in files and views: "person 3".
std::string personName(int identity);
/// Returns the identity in a name of the form "person 3", or nothing for any other name.
std::optional<int> identityFromName(std::string_view name);

} // namespace dewpoint::tracking
