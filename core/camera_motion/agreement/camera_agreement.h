// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/camera_motion/agreement/sighting_history.h"
#include "core/capture/frame.h"
#include "core/geometry/camera.h"
#include "core/tracking/target.h"

#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

class AgreementModel;
struct AgreementFit;

/// Monitors whether the cameras of a rig agree about the positions of objects, and names the most
/// likely reason if the cameras do not agree. The constructor checks the rig itself (checkRig()).
/// During tracking, watch() compares where the cameras see moving regions in the targets' colors,
/// whether or not a target is tracked. A few seconds of motion are enough. Regions at rest are not
/// used, because cameras may see different objects at rest in the same color.
class CameraAgreement {
public:
  explicit CameraAgreement(const CameraRig& rig);

  /// Adds the next images, and checks the agreement from time to time. Images older than the
  /// previous images are ignored.
  void watch(const FrameSet& frames, const std::vector<Target>& targets);

  /// Returns the faults found so far: first the faults of the rig itself, then at most one fault
  /// derived from the images. The fault derived from the images is removed when the cameras agree
  /// again.
  const std::vector<CameraDisagreement>& disagreements() const { return found_; }

  /// Discards all sightings and starts from scratch.
  void restart();

private:
  void updateColors(const std::vector<Target>& targets);
  /// Returns whether the sightings are suitable for a check: enough regions in total, but not too
  /// many in one image.
  bool hasEnoughSightings() const;
  void check(double time);
  void onGoodFit(const AgreementModel& model, const AgreementFit& asDeclared, double time);
  void onDoubtfulFit(const AgreementModel& model, const AgreementFit& asDeclared, double time);
  /// Sets whether the images are checked only occasionally from now on.
  void setSparseChecking(bool sparse);
  void report(const std::optional<CameraDisagreement>& seen);

  CameraRig rig_;
  std::vector<CameraDisagreement> found_;
  std::size_t rigFaultCount_ = 0; ///< number of faults in found_ that concern the rig itself
  std::vector<ColorRanges> colors_;
  std::vector<double> radii_; ///< target radius for each color, meters; 0: unknown
  std::vector<std::vector<SightingHistory>> histories_; ///< [color][camera]
  std::vector<double> lastTimes_; ///< time of the last image of each camera, seconds
  double due_ = 0.0;              ///< time of the next check, seconds
  double wait_ = 0.0; ///< interval between checks, seconds; not used while `sparse_` is true
  /// Since when the rig has explained hardly any sightings, seconds.
  std::optional<double> badSince_;
  /// Since when the rig has explained only some sightings, seconds.
  std::optional<double> unclearSince_;
  /// Since when the rig has explained the sightings well, seconds.
  std::optional<double> goodSince_;
  bool sparse_ = false; ///< true if the rig has been confirmed and is checked only occasionally
  std::optional<CameraDisagreement> suspected_; ///< fault suspected by the last check
};

} // namespace dewpoint::camera_motion
