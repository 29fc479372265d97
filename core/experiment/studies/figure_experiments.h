// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/experiment_options.h"

#include <span>
#include <string_view>
#include <vector>

namespace dewpoint::experiment {

/// Group under which an experiment is listed.
enum class ExperimentGroup { Barrera, Sugandi, Mohedano, People };

/// Returns the heading of a group: the paper, or the topic of experiments that do not belong to a
/// paper.
std::string_view experimentGroupTitle(ExperimentGroup group);

/// Experiment that one command runs: it reproduces a figure or table of a paper, or it is one of
/// Dewpoint's own studies.
struct FigureExperiment {
  std::string_view name;        ///< name on the command line
  std::string_view title;       ///< name in menus and reports
  std::string_view description; ///< what the experiment shows, and its source
  int runCount;                 ///< default number of seeds per case
  /// Runs the experiment and writes its report. Returns FileUnwritable, before any computation
  /// starts, if the output folder cannot be written, and Canceled if the user stops it.
  Status (*run)(const ExperimentOptions& options);
  std::string_view reportFile = "report.html"; ///< report file in the output folder
  bool usesRecordings = false;
  bool hasClothesOption = false;
  ExperimentGroup group = ExperimentGroup::Barrera;
};

/// Returns the experiments that reproduce figures of the papers.
std::span<const FigureExperiment> figureExperiments();
/// Returns all experiments, including boxAndPeopleExperiments(), in menu order: by group, with
/// figures first within each group.
std::vector<const FigureExperiment*> listedExperiments();

} // namespace dewpoint::experiment
