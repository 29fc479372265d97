// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/box_clips.h"
#include "core/experiment/box_metrics.h"
#include "core/experiment/sloppy_study.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint {

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
};

/// A requirement with its verdict.
struct BoxBar {
  std::string sentence;
  bool reached = false;
};

struct BoxStudy {
  std::vector<BoxRow> rows; ///< clip by clip
  std::vector<BoxBar> bars;
  std::vector<SloppyRow> sloppy; ///< of studySloppyBoxes(); empty unless asked for
};

/// Follows every clip with `sugandi` of 100 and of 300 particles, `histogram` and OpenCV's four
/// trackers. `report` gets each row as it is done; it returns false to stop.
Result<BoxStudy> studyBoxes(const std::vector<BoxClip>& clips, int seeds,
                            const std::function<bool(const BoxRow&)>& report);

/// The study as text with aligned columns, as CSV, and as a page.
std::string boxStudyText(const BoxStudy& study);
std::string boxStudyCsv(const BoxStudy& study);
std::string boxStudyHtml(const BoxStudy& study);

/// What sloppy first boxes led to, as CSV; without numbers in the last three columns where a method
/// does not say how sure it is.
std::string sloppyBoxesCsv(const std::vector<SloppyRow>& rows);

/// Writes sugandi-rmse.txt, .csv and .html, and sloppy-boxes.csv where that was studied, into a
/// folder that exists.
Status writeBoxStudy(const BoxStudy& study, const std::filesystem::path& folder);

} // namespace dewpoint
