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

/// Bounding box of one target in one image.
struct BoxSample {
  double time = 0.0;      ///< seconds since the first frame
  std::int64_t frame = 0; ///< frame number, counted from 0
  int target = 1; ///< target number, counted from 1 in the order in which the boxes were defined
  BoxEstimate estimate;
};

/// Bounding boxes of a run, frame by frame.
struct BoxTrack {
  /// Settings of the run: method, seed, parameters.
  std::vector<std::pair<std::string, std::string>> header;
  std::vector<BoxSample> samples;
};

/// Whether a CSV file begins with notes: lines about the run, each starting with `#`.
enum class CsvNotes { Written, LeftOut };

/// Returns the bounding boxes as CSV text: notes, column names, and one row per target and frame.
/// The box and its center are in pixels from the upper left corner of the image.
std::string boxCsv(const BoxTrack& track, CsvNotes notes = CsvNotes::Written);

/// Returns the bounding boxes in the text format of the MOT challenge (Leal-Taixé et al. 2015):
/// frame, identity, left, top, width, height, confidence, -1, -1, -1. Frames, identities and pixel
/// coordinates are counted from 1. The confidence is the similarity to the target's reference
/// histogram. Hidden targets have no row.
std::string boxMotText(const BoxTrack& track);

/// Writes the bounding boxes to boxes.csv and boxes_mot.txt in an existing folder.
Status writeBoxTrack(const BoxTrack& track, const std::filesystem::path& folder,
                     CsvNotes notes = CsvNotes::Written);

} // namespace dewpoint::session
