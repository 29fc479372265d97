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

/// Display names of the methods that the report draws.
inline constexpr const char* kSugandiFew = "sugandi, 100 particles";
inline constexpr const char* kSugandiMany = "sugandi, 300 particles";
inline constexpr const char* kHistogram = "histogram, 300 particles";
/// Name of the page among the files of the study.
inline constexpr const char* kBoxReport = "sugandi-rmse.html";

/// Results of one method on one clip, from the true box of the first frame; means over the seeds.
struct BoxRow {
  std::string clip;
  std::string method; ///< display name: "sugandi, 100 particles", "csrt"
  bool ours = false;  ///< one of our methods, otherwise OpenCV's
  bool exactBoxes = true;
  int seeds = 1;
  BoxMetrics metrics;
  double worstPrecision = 0.0; ///< of the seeds
  double milliseconds = 0.0;   ///< per frame, one thread
  /// Boxes of the first seed, one per frame from the given one on; nothing after it has given up.
  std::vector<std::optional<ImageBox>> boxes;
};

/// Requirement, and whether it was reached.
struct BoxBar {
  std::string sentence;
  bool reached = false;
};

/// Data for the figures of a clip.
struct BoxClipFigures {
  std::string clip;
  std::vector<ImageBox> truth;
  cv::Mat frames; ///< see boxFrames()
  /// Color histograms (boxHistogram()) of the given box, and of the box that `sugandi` with 300
  /// particles found at a frame halfway through the clip; empty if that is outside the image.
  std::vector<double> reference;
  std::vector<double> candidate;
  std::size_t candidateFrame = 0;
};

/// Results of the study of boxes.
struct BoxStudy {
  std::vector<BoxRow> rows; ///< clip by clip
  std::vector<BoxBar> bars;
  std::vector<BoxClipFigures> figures;       ///< one per clip
  std::vector<BoxPerturbationRow> perturbed; ///< of studyPerturbedBoxes(); empty unless requested
  std::uint64_t firstSeed = kFirstTuningSeed;
  int seeds = 1; ///< seeds of our methods
};

/// Follows every clip with `sugandi` (100 and 300 particles), `histogram` and OpenCV's four
/// trackers. Ours run with `seeds` seeds from `firstSeed` on. `report` receives each row when it is
/// done; it returns false to stop.
Result<BoxStudy> studyBoxes(const std::vector<BoxClip>& clips, int seeds,
                            const std::function<bool(const BoxRow&)>& report,
                            std::uint64_t firstSeed = kFirstTuningSeed);

} // namespace dewpoint::experiment
