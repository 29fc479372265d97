// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/target_exposure.h"
#include "core/session/snapshot/snapshot.h"

#include <string>
#include <vector>

namespace dewpoint::session {

/// Exposure of one target in the image of one camera.
struct ExposureInView {
  std::size_t target = 0; ///< index in TrackSnapshot::targets
  std::string name;       ///< of the target
  /// True if its pixels were found by tracking; false if they are the region of a color sample.
  bool isTracked = false;
  TargetExposure exposure;
};

/// Returns the exposure of each target that a camera of a snapshot sees, in the order of the
/// targets. A target that is tracked and confirmed by the camera is measured inside its estimated
/// outline. Any other target is measured in the region of its newest color sample from this camera,
/// if the image still shows the sampled object there. People are not measured. This may take some
/// ten milliseconds.
std::vector<ExposureInView> exposuresInView(const TrackSnapshot& snapshot, int camera);

/// Returns the target with the worst exposure: the largest fraction of clipped pixels, or of dark
/// pixels if none is clipped too much. Null if the list is empty.
const ExposureInView* worstExposure(const std::vector<ExposureInView>& exposures);

} // namespace dewpoint::session
