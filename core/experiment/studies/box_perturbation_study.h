// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/boxes/box_clips.h"
#include "core/experiment/metrics/box_metrics.h"
#include "core/experiment/report/seed_blocks.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Difference between an inexact first box, as a user might draw it, and the true box.
struct BoxPerturbation {
  double scale = 1.0;      ///< factor for width and height
  double shiftRight = 0.0; ///< shift of the center to the right, in widths of the true box
  double shiftDown = 0.0;  ///< downward shift of the center, in heights of the true box

  ImageBox appliedTo(const ImageBox& box) const {
    return ImageBox::around(box.center() +
                                Eigen::Vector2d(shiftRight * box.width, shiftDown * box.height),
                            scale * box.width, scale * box.height);
  }
};

/// Returns all perturbations: 0.8, 1, 1.2 and 1.4 times the true size, each unshifted and shifted
/// by 15 % to the left, to the right, up and down.
std::vector<BoxPerturbation> boxPerturbations();

/// Results of one method on one clip, started with first boxes of one size: one unshifted box and
/// all shifted boxes. The values are means over all runs.
struct BoxPerturbationRow {
  std::string clip;
  std::string method; ///< name of the method, for example "histogram" or "csrt"
  double scale = 1.0; ///< scale of the first box
  int runCount = 0;   ///< number of runs: shifts times seeds
  BoxMetrics metrics; ///< accuracy of the found boxes compared with the true boxes
  /// Smallest BoxMetrics::precision (fraction of frames on the target) of any run.
  double worstPrecision = 1.0;
  bool reportsConfidence =
      false; ///< true if the method reports its confidence; only then are the following fields set
  /// Mean reported similarity in frames in which the found center is within the clip's radius
  /// (BoxClip::hitRadiusPx) of the true center.
  double similarityOnTarget = 0.0;
  /// Mean reported similarity in frames in which the found center is farther than the clip's radius
  /// (BoxClip::hitRadiusPx) from the true center; the similarity counts as 0 if the method reports
  /// the target as hidden.
  double similarityOffTarget = 0.0;
  /// Fraction of the frames with a reported confidence in which the found center is farther than
  /// the clip's radius (BoxClip::hitRadiusPx) from the true center although the similarity is above
  /// 0.9.
  double confidentlyWrongShare = 0.0;
};

/// Returns the methods that are compared by default in the study of inexact first boxes
/// (studyPerturbedBoxes()).
std::vector<std::string> perturbationMethods();

/// Follows every clip from inexact first boxes (boxPerturbations()) with each of `methods`.
/// Dewpoint's own methods use 300 particles and `seeds` runs, with seeds from `firstSeed` on.
/// `report` receives each row when it is finished, and returns false to stop.
Result<std::vector<BoxPerturbationRow>>
studyPerturbedBoxes(const std::vector<BoxClip>& clips, int seeds,
                    const std::function<bool(const BoxPerturbationRow&)>& report,
                    const std::vector<std::string>& methods = perturbationMethods(),
                    std::uint64_t firstSeed = kFirstTuningSeed);

} // namespace dewpoint::experiment
