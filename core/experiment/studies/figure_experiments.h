// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/experiment_options.h"

#include <span>
#include <string_view>
#include <vector>

namespace dewpoint::experiment {

/// Under which heading an experiment is listed.
enum class ExperimentGroup { Barrera, Sugandi, Mohedano, People };

/// The heading: the paper, or what the experiments of no paper are about.
std::string_view experimentGroupTitle(ExperimentGroup group);

/// A figure or a table of a paper, reproduced by one command, or a study of our own.
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
  ExperimentGroup group = ExperimentGroup::Barrera;
};

/// Figures of the papers.
std::span<const FigureExperiment> figureExperiments();
/// These and studyExperiments(), in the order of menus: by group, and within a group figures first.
std::vector<const FigureExperiment*> listedExperiments();

} // namespace dewpoint::experiment
