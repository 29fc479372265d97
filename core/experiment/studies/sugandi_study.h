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

/// How methods are shown that the report draws.
inline constexpr const char* kSugandiFew = "sugandi, 100 particles";
inline constexpr const char* kSugandiMany = "sugandi, 300 particles";
inline constexpr const char* kHistogram = "histogram, 300 particles";
/// The page among the files of the study.
inline constexpr const char* kBoxReport = "sugandi-rmse.html";

/// One method on one clip, from the true box of the first frame; means over the seeds.
struct BoxRow {
  std::string clip;
  std::string method; ///< as shown: "sugandi, 100 particles", "csrt"
  bool ours = false;  ///< one of our methods, else OpenCV's
  bool exactBoxes = true;
  int seeds = 1;
  BoxFigures figures;
  double worstPrecision = 0.0; ///< of the seeds
  double milliseconds = 0.0;   ///< per frame, one thread
  /// Of the first seed, one per frame from the given one on; nothing where it has given up.
  std::vector<std::optional<ImageBox>> boxes;
};

/// A requirement, and whether it was reached.
struct BoxBar {
  std::string sentence;
  bool reached = false;
};

/// What a clip's figures are drawn from.
struct BoxClipFigures {
  std::string clip;
  std::vector<ImageBox> truth;
  cv::Mat frames; ///< see boxFrames()
  /// Color histograms (boxHistogram()) of the given box, and of the one that `sugandi` with 300
  /// particles found at a frame in the middle of the clip; empty where that lies outside the image.
  std::vector<double> reference;
  std::vector<double> candidate;
  std::size_t candidateFrame = 0;
};

struct BoxStudy {
  std::vector<BoxRow> rows; ///< clip by clip
  std::vector<BoxBar> bars;
  std::vector<BoxClipFigures> figures;       ///< one per clip
  std::vector<BoxPerturbationRow> perturbed; ///< of studyPerturbedBoxes(); empty unless requested
  std::uint64_t firstSeed = kFirstTuningSeed;
  int seeds = 1; ///< of our methods
};

/// Follows every clip with `sugandi` of 100 and of 300 particles, `histogram` and OpenCV's four
/// trackers, ours with `seeds` seeds from `firstSeed` on. `report` gets each row as it is done; it
/// returns false to stop.
Result<BoxStudy> studyBoxes(const std::vector<BoxClip>& clips, int seeds,
                            const std::function<bool(const BoxRow&)>& report,
                            std::uint64_t firstSeed = kFirstTuningSeed);

} // namespace dewpoint::experiment
