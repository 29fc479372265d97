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

/// Watches whether the cameras of a rig can agree on where things are, and names the likeliest
/// reason when they cannot: by the rig alone at once (checkRig()), and by where regions of the
/// targets' colors are seen while they move, whether or not anything is tracked. A few seconds of
/// motion are enough; what is at rest tells nothing, since it may be another thing in each image.
class CameraAgreement {
public:
  explicit CameraAgreement(const CameraRig& rig);

  /// The next images. Images of the past are passed over.
  void watch(const FrameSet& frames, const std::vector<Target>& targets);

  /// What is wrong, as far as it is known: faults of the rig alone first, then at most one that the
  /// images show. It goes when the images agree again.
  const std::vector<CameraDisagreement>& found() const { return found_; }

  /// Forgets what was seen.
  void restart();

private:
  void takeColors(const std::vector<Target>& targets);
  /// Whether enough was seen, and not too much at once.
  bool tellsSomething() const;
  void check(double time);
  void takeGood(const AgreementModel& model, const AgreementFit& asDeclared, double time);
  void takeDoubtful(const AgreementModel& model, const AgreementFit& asDeclared, double time);
  /// Whether the rig is looked at now and then only, from now on.
  void settle(bool settled);
  void report(const std::optional<CameraDisagreement>& seen);

  CameraRig rig_;
  std::vector<CameraDisagreement> found_;
  std::size_t ofRig_ = 0; ///< of found_, those of the rig alone
  std::vector<ColorRanges> colors_;
  std::vector<double> radii_; ///< of the targets of each color, meters; 0: unknown
  std::vector<std::vector<SightingHistory>> histories_; ///< [color][camera]
  std::vector<double> lastTimes_;                       ///< per camera, of images; seconds
  double due_ = 0.0;                                    ///< the next check, seconds
  double wait_ = 0.0;                                   ///< until the check after it
  std::optional<double> badSince_;     ///< the rig explains hardly anything, seconds
  std::optional<double> unclearSince_; ///< not everything
  std::optional<double> goodSince_;
  bool settled_ = false; ///< the rig has proved right: it is looked at now and then
  std::optional<CameraDisagreement> suspected_; ///< by the last check
};

} // namespace dewpoint::camera_motion
