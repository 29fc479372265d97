// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/report/figure_page.h"
#include "core/experiment/studies/people_study.h"

#include <limits>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Summary of the trials of one scenario, grade, kind of clothes and method.
struct PeopleSummary {
  std::string scenario;
  Grade grade = Grade::Ideal;
  PeopleClothes clothes = PeopleClothes::Different;
  std::string method;
  int runs = 0;
  int kept = 0;
  int identitySwitches = 0;
  double mota = 0.0; ///< mean, like the next three
  double hota = 0.0;
  double gospa = 0.0;         ///< meters
  double motp = 0.0;          ///< meters; over runs with matches
  double longestGhost = 0.0;  ///< seconds, worst run
  double longestMissed = 0.0; ///< seconds, worst run
  double hullVolume = 0.0;    ///< m³, mean
  double stepMs = 0.0;        ///< mean
  /// Means of PeopleTrial::everybody over the runs that have them: see PersonResult.
  double found = std::numeric_limits<double>::quiet_NaN();
  SilhouetteScores silhouette;
};

/// Name of a kind of clothes in tables and files.
const char* clothesName(PeopleClothes clothes);

/// Summaries in the order in which they first occur.
std::vector<PeopleSummary> summarize(const std::vector<PeopleTrial>& trials);
/// Rows of a table for a terminal, and its head.
std::string peopleTableHead();
std::string peopleTableRow(const PeopleSummary& summary);
/// Content of runs.csv: one row per trial.
std::string peopleTrialsCsv(const std::vector<PeopleTrial>& trials);
/// Content of people.csv: one row per trial and person.
std::string peoplePersonsCsv(const std::vector<PeopleTrial>& trials);
/// Report of a study: a description of the experiment, its table, the result for the paper's figure
/// 4(a), the bars and which of them are missed, people by height if some are small, and the
/// pictures of the trials that have some. It also has runs.csv and people.csv.
FigurePage peopleReport(const std::string& scenario, const std::vector<PeopleTrial>& trials);

} // namespace dewpoint::experiment
