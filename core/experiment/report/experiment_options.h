// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"
#include "core/experiment/report/seed_blocks.h"

#include <filesystem>
#include <functional>

namespace dewpoint::experiment {

/// Of which clothes the simulated people are.
enum class StudyClothes { Both, Different, Similar };

/// How an experiment is run.
struct ExperimentOptions {
  std::filesystem::path folder; ///< report.html, pictures and numbers go there; it is made
  int runs = 0; ///< seeds per case, from firstSeed on; 0: as many as the experiment declares
  /// Told how far it is (0 to 1); returns false to stop.
  std::function<bool(double part)> progress = {};
  /// Folder with the recordings juggle1 and otb; empty: none. Of those that take recordings.
  std::filesystem::path recordings = {};
  StudyClothes clothes = StudyClothes::Both; ///< of those that take clothes
  std::uint64_t firstSeed = kFirstReportingSeed;
};

} // namespace dewpoint::experiment
