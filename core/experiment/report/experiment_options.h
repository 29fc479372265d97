// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"
#include "core/experiment/report/seed_blocks.h"

#include <filesystem>
#include <functional>

namespace dewpoint::experiment {

/// Clothes of the simulated people.
enum class StudyClothes { Both, Different, Similar };

/// Options of an experiment.
struct ExperimentOptions {
  /// Output folder for report.html, pictures and numbers; it is created.
  std::filesystem::path folder;
  int runs = 0; ///< seeds per case, from firstSeed on; 0: as the experiment declares
  /// Receives the progress (0 to 1); returns false to stop.
  std::function<bool(double part)> progress = {};
  /// Folder with the recordings juggle1 and otb; empty: none. For experiments that take recordings.
  std::filesystem::path recordings = {};
  StudyClothes clothes = StudyClothes::Both; ///< for experiments that take clothes
  std::uint64_t firstSeed = kFirstReportingSeed;
};

} // namespace dewpoint::experiment
