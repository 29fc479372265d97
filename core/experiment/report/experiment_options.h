// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"
#include "core/experiment/report/seed_blocks.h"

#include <filesystem>
#include <functional>

namespace dewpoint::experiment {

/// Clothes of the simulated people in a study.
enum class StudyClothes { Both, Different, Similar };

/// Options of an experiment.
struct ExperimentOptions {
  /// Output folder for report.html, images and numbers. It is created if it does not exist.
  std::filesystem::path outputFolder;
  int runCount = 0; ///< number of seeds per case, from firstSeed on; 0: the experiment's default
  /// Callback that receives the progress `part` (0 to 1). It returns false to stop the experiment.
  std::function<bool(double part)> progress = {};
  /// Folder with the recordings juggle1 and otb. Empty if there are no recordings. Used by
  /// experiments with FigureExperiment::usesRecordings.
  std::filesystem::path recordingsFolder = {};
  /// Clothes of the simulated people. Used by experiments with FigureExperiment::hasClothesOption.
  StudyClothes clothes = StudyClothes::Both;
  std::uint64_t firstSeed = kFirstReportingSeed;
};

} // namespace dewpoint::experiment
