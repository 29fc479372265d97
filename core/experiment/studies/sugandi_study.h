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

/// Display names of the methods that the report plots.
inline constexpr const char* kSugandiFew = "sugandi, 100 particles";
inline constexpr const char* kSugandiMany = "sugandi, 300 particles";
inline constexpr const char* kHistogram = "histogram, 300 particles";
/// File name of the study's HTML page.
inline constexpr const char* kBoxReport = "sugandi-rmse.html";

/// Results of one method on one clip, started with the true box of the first frame. Values are
/// means over the seeds.
struct BoxStudyRow {
  std::string clip;
  std::string method;  ///< display name: "sugandi, 100 particles", "csrt"
  bool isOurs = false; ///< true: one of Dewpoint's own methods; false: one of OpenCV's
  bool exactBoxes = true;
  int seeds = 1;
  BoxMetrics metrics;
  double worstPrecision = 0.0; ///< worst precision over the seeds
  double milliseconds = 0.0;   ///< time per frame with one thread, ms
  /// Boxes for the first seed, one per frame, beginning with the first frame, whose box is given.
  /// An entry is empty after the method has given up.
  std::vector<std::optional<ImageBox>> boxes;
};

/// Requirement of the study, and whether it is met.
struct BoxRequirement {
  std::string description;
  bool reached = false;
};

/// Data for the figures of a clip.
struct BoxClipFigures {
  std::string clip;
  std::vector<ImageBox> truth;
  cv::Mat frames; ///< image from drawBoxFrames()
  /// Color histogram of the first box, which was given to the method (boxHistogram()). Empty if the
  /// box is outside the image.
  std::vector<double> referenceHistogram;
  /// Color histogram of the box that `sugandi` with 300 particles found in `candidateFrame`,
  /// halfway through the clip. Empty if the box is outside the image.
  std::vector<double> candidateHistogram;
  std::size_t candidateFrame = 0;
};

/// Results of the box study.
struct BoxStudy {
  std::vector<BoxStudyRow> rows; ///< grouped by clip
  std::vector<BoxRequirement> requirements;
  std::vector<BoxClipFigures> figures; ///< one per clip
  std::vector<BoxPerturbationRow>
      perturbedRows; ///< results of studyPerturbedBoxes(); empty unless requested
  std::uint64_t firstSeed = kFirstTuningSeed;
  int seeds = 1; ///< number of seeds for Dewpoint's own methods
};

/// Follows every clip with `sugandi` (100 and 300 particles), `histogram` and OpenCV's four
/// trackers. Dewpoint's own methods run with `seeds` seeds from `firstSeed` on. `report` receives
/// each row when it is finished, and returns false to stop.
Result<BoxStudy> studyBoxes(const std::vector<BoxClip>& clips, int seeds,
                            const std::function<bool(const BoxStudyRow&)>& report,
                            std::uint64_t firstSeed = kFirstTuningSeed);

} // namespace dewpoint::experiment
