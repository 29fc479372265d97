// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/boxes/box_clips.h"
#include "core/experiment/metrics/box_metrics.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/studies/box_perturbation_study.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Display names of the methods in the plots of the report: `sugandi` with few (100) and many (300)
/// particles, and `histogram`.
inline constexpr const char* kSugandiFew = "sugandi, 100 particles";
inline constexpr const char* kSugandiMany = "sugandi, 300 particles";
inline constexpr const char* kHistogram = "histogram, 300 particles";
/// File name of the study's HTML page.
inline constexpr const char* kBoxReport = "sugandi-rmse.html";

/// Results of one method on one clip (short image sequence of one camera), started with the true
/// box of the first frame. Values are means over the seeds.
struct BoxStudyRow {
  std::string clip;
  std::string method;            ///< display name: "sugandi, 100 particles", "csrt"
  bool isDewpointMethod = false; ///< true: one of Dewpoint's own methods; false: one of OpenCV's
  bool hasExactBoxes = true;
  int seedCount = 1;
  BoxMetrics metrics;
  /// Lowest precision over the seeds. Precision is the fraction of frames in which the found center
  /// is near the true one (BoxMetrics).
  double worstPrecision = 0.0;
  double millisecondsPerFrame = 0.0; ///< time per frame with one thread, ms
  /// Boxes for the first seed, one per frame, beginning with the first frame, whose box is given.
  /// An entry is empty after the method has given up.
  std::vector<std::optional<ImageBox>> boxes;
};

/// Requirement that the study checks, and whether the results meet it.
struct BoxRequirement {
  std::string description;
  bool isMet = false;
};

/// Data for the figures (pictures and plots) that the report shows for one clip.
struct BoxClipFigures {
  std::string clip;
  std::vector<ImageBox> truth;
  cv::Mat framesImage; ///< image of some frames with the found and the true boxes
  /// Color histogram of the first box, which was given to the method (boxHistogram()). Empty if the
  /// box is outside the image.
  std::vector<double> referenceHistogram;
  /// Color histogram of the box that `sugandi` with 300 particles found in `candidateFrame`,
  /// halfway through the clip. Empty if the box is outside the image.
  std::vector<double> candidateHistogram;
  std::size_t candidateFrame = 0;
};

/// Results of the study that compares methods for tracking a bounding box in one camera.
struct BoxStudy {
  std::vector<BoxStudyRow> rows; ///< grouped by clip
  std::vector<BoxRequirement> requirements;
  std::vector<BoxClipFigures> figures; ///< one per clip
  /// Results with inexact first boxes, from studyPerturbedBoxes(); empty unless this part was
  /// requested.
  std::vector<BoxPerturbationRow> perturbedRows;
  std::uint64_t firstSeed = kFirstTuningSeed;
  int seedCount = 1; ///< number of seeds for Dewpoint's own methods
};

/// Follows the box of the target through every clip with `sugandi` (100 and 300 particles),
/// `histogram` and OpenCV's four trackers. Dewpoint's own methods run with `seeds` seeds from
/// `firstSeed` on. `report` receives each row when it is finished, and returns false to stop.
Result<BoxStudy> studyBoxes(const std::vector<BoxClip>& clips, int seeds,
                            const std::function<bool(const BoxStudyRow&)>& report,
                            std::uint64_t firstSeed = kFirstTuningSeed);

} // namespace dewpoint::experiment
