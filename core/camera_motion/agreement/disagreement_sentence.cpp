// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/agreement/disagreement_sentence.h"

#include "core/base/units.h"
#include "core/geometry/camera_name.h"

#include <fmt/format.h>

#include <cmath>

namespace dewpoint::camera_motion {

std::string describeDisagreement(const CameraDisagreement& found, const CameraRig& rig) {
  const auto name = [&](std::size_t i) {
    const std::size_t camera = found.cameras.at(i);
    return geometry::nameOrNumber(rig[camera], camera);
  };
  switch (found.fault) {
  case CameraFault::Swapped:
    return found.cameras.size() > 2
               ? fmt::format("{} and {} seem to be swapped, or {} and {}; exchange the images of "
                             "the two in the project file",
                             name(0), name(1), name(2), name(3))
               : fmt::format("{} and {} seem to be swapped; exchange their images in the project "
                             "file",
                             name(0), name(1));
  case CameraFault::Late:
    return fmt::format(
        "the images of {} are about {:.0f} ms {}; add {:.3f} to its late_by in the project file",
        name(0), inMilliseconds(std::abs(found.delay)), found.delay > 0.0 ? "late" : "early",
        found.delay);
  case CameraFault::Rotated:
    return found.cameras.size() > 1
               ? fmt::format(
                     "{} or {} points at least {:.1f} degrees away from its calibrated direction; "
                     "calibrate them again",
                     name(0), name(1), inDegrees(found.rotationCorrections.at(0).norm()))
               : fmt::format(
                     "{} points about {:.1f} degrees away from its calibrated direction; calibrate "
                     "it again",
                     name(0), inDegrees(found.rotationCorrections.at(0).norm()));
  case CameraFault::Unit:
    return fmt::format("the calibration seems to be in units of {:g} m; it must be in meters",
                       found.metersPerUnit);
  case CameraFault::SamePose:
    return fmt::format("{} and {} have the same pose; calibrate them again", name(0), name(1));
  case CameraFault::Unknown:
    break;
  }
  return found.cameras.size() > 1
             ? fmt::format("{} and {} disagree about where the target is; calibrate them again",
                           name(0), name(1))
             : fmt::format("{} does not agree with the other cameras; calibrate it again", name(0));
}

} // namespace dewpoint::camera_motion
