// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/experiment_options.h"

#include <span>
#include <string_view>

namespace dewpoint::experiment {

/// A figure or a table of a paper, reproduced by one command.
struct FigureExperiment {
  std::string_view name;     ///< as on the command line
  std::string_view title;    ///< for people
  std::string_view sentence; ///< what it shows, and from where
  int runs;                  ///< seeds per case unless given
  /// FileUnwritable, before anything is begun; Cancelled.
  Status (*run)(const ExperimentOptions& options);
  std::string_view report = "report.html"; ///< in the folder
  bool takesRecordings = false;
  bool takesClothes = false;
};

/// All of them, in the order of menus.
std::span<const FigureExperiment> figureExperiments();
/// The studies of boxes and of people, as experiments with defaults that take minutes: sugandi-rmse
/// and people-<scenario> of the paper's scenes. The command line has all scenes and options.
std::span<const FigureExperiment> studyExperiments();

} // namespace dewpoint::experiment
