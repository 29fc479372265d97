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

/// Heading of a group: the paper, or the topic of experiments without a paper.
std::string_view experimentGroupTitle(ExperimentGroup group);

/// Figure or table of a paper, reproduced by one command, or a study of our own.
struct FigureExperiment {
  std::string_view name;     ///< name on the command line
  std::string_view title;    ///< name in menus and reports
  std::string_view sentence; ///< what it shows, and its source
  int runs;                  ///< seeds per case unless given
  /// FileUnwritable, before anything is begun; Canceled.
  Status (*run)(const ExperimentOptions& options);
  std::string_view report = "report.html"; ///< file in the folder
  bool takesRecordings = false;
  bool takesClothes = false;
  ExperimentGroup group = ExperimentGroup::Barrera;
};

/// Figures of the papers.
std::span<const FigureExperiment> figureExperiments();
/// All experiments, including studyExperiments(), in the order of menus: by group, and within a
/// group figures first.
std::vector<const FigureExperiment*> listedExperiments();

} // namespace dewpoint::experiment
