// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/tracking/track_estimate.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// Where one target was in one image.
struct BoxSample {
  double time = 0.0;      ///< seconds since the first frame
  std::int64_t frame = 0; ///< from 0
  int target = 1;         ///< from 1, in the order in which the boxes were given
  BoxEstimate estimate;
};

/// The boxes of a run, frame by frame.
struct BoxTrack {
  std::vector<std::pair<std::string, std::string>> header; ///< method, seed, parameters
  std::vector<BoxSample> samples;
};

/// CSV: `#` header, column names, one row per target and frame. Pixels from the image's upper left
/// corner; the box and its center.
std::string boxCsv(const BoxTrack& track);

/// The text format of the MOT challenge (Leal-Taixé et al. 2015): frame, identity, left, top,
/// width, height, confidence, -1, -1, -1, all counted from 1. The confidence is the similarity.
/// Hidden targets have no row.
std::string boxMotText(const BoxTrack& track);

/// Writes boxes.csv and boxes_mot.txt into a folder that exists.
Status writeBoxTrack(const BoxTrack& track, const std::filesystem::path& folder);

} // namespace dewpoint::session
