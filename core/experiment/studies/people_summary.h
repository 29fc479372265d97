// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/report/figure_page.h"
#include "core/experiment/studies/people_study.h"

#include <limits>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// What the trials of one scenario, grade, kind of clothes and method add up to.
struct PeopleSummary {
  std::string scenario;
  Grade grade = Grade::Ideal;
  PeopleClothes clothes = PeopleClothes::Different;
  std::string method;
  int runs = 0;
  int kept = 0;
  int identitySwitches = 0;
  double mota = 0.0; ///< mean, as the next three
  double hota = 0.0;
  double gospa = 0.0;         ///< meters
  double motp = 0.0;          ///< meters; over the runs that have matches
  double longestGhost = 0.0;  ///< seconds, the worst run
  double longestMissed = 0.0; ///< seconds, the worst run
  double hullVolume = 0.0;    ///< m³, mean
  double stepMs = 0.0;        ///< mean
  /// Means over the runs that have them, of PeopleTrial::everybody: see PersonResult.
  double found = std::numeric_limits<double>::quiet_NaN();
  SilhouetteScores silhouette;
};

const char* clothesName(PeopleClothes clothes);

/// In the order in which they come first.
std::vector<PeopleSummary> summarize(const std::vector<PeopleTrial>& trials);
/// A table for a terminal, and its head.
std::string peopleTableHead();
std::string peopleTableRow(const PeopleSummary& summary);
/// runs.csv: a row per trial.
std::string peopleTrialsCsv(const std::vector<PeopleTrial>& trials);
/// people.csv: a row per trial and person.
std::string peoplePersonsCsv(const std::vector<PeopleTrial>& trials);
/// The report: what the experiment is, its table, what came out of the paper's figure 4(a), the
/// bars and which of them are missed, people by height where some are small, the pictures of the
/// trials that have some; runs.csv and people.csv beside it.
FigurePage peopleReport(const std::string& scenario, const std::vector<PeopleTrial>& trials);

} // namespace dewpoint::experiment
