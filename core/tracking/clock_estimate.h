// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::tracking {

/// Estimated clock error of a camera relative to the first camera of the rig. All values are 0 for
/// the first camera: the images do not show a delay that all cameras have in common.
struct ClockEstimate {
  /// Delay in seconds from the capture of an image to its time stamp, minus the same delay of the
  /// first camera. Known delays are not included, because the time stamps are already corrected for
  /// them.
  double delaySeconds = 0.0;
  double delaySigma =
      0.0;            ///< standard deviation of `delaySeconds`, seconds; 0: nothing is estimated
  double drift = 0.0; ///< change of `delaySeconds`, seconds per second
  double driftSigma = 0.0; ///< standard deviation of `drift`
};

} // namespace dewpoint::tracking
