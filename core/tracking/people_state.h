// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <string_view>

namespace dewpoint::tracking {

/// The 3D points that stand for where a person's body is: rows x y z, meters, with linear weights
/// that sum to 1.
struct BodyCloud {
  Eigen::ArrayXXd points;
  Eigen::ArrayXd weights;
};

/// What is known about one camera's background.
struct PeopleCameraState {
  double learned = 0.0;         ///< 0 to 1: how much of the learning phase is over
  double foregroundShare = 0.0; ///< of the image, 0 to 1
  bool usable = false;          ///< had an image, is learned, and is not all foreground
};

/// How a person is called in files and views: "person 3".
std::string personName(int identity);
/// The identity in such a name; nothing for any other name.
std::optional<int> personIdentity(std::string_view name);

} // namespace dewpoint::tracking
