// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
  int runCount = 0;
  int keptRunCount =
      0; ///< number of runs in which all identities were kept (PeopleTrial::hasKeptIdentities)
  int identitySwitches = 0;
  double mota = 0.0; ///< CLEAR MOT accuracy, mean over runs
  double hota = 0.0;
  double gospa = 0.0; ///< GOSPA distance, mean over runs, meters
  double motp = 0.0;  ///< distance of matches, mean over the runs that have any, meters
  /// Longest time with an estimate but no person nearby, over all runs, seconds.
  double longestGhostSeconds = 0.0;
  /// Longest time without an estimate of a visible person, over all runs, seconds.
  double longestMissedSeconds = 0.0;
  double hullVolume = 0.0; ///< volume that contains 95 % of a person, mean over runs, m³
  double stepMs = 0.0;     ///< CPU time per frame with people, mean over runs, ms
  /// Means of the fields `found` and `silhouette` in PeopleTrial::allPersonsResult, over the runs
  /// that have a value; see PersonResult.
  double found = std::numeric_limits<double>::quiet_NaN();
  SilhouetteScores silhouette;
};

/// Returns the name of a kind of clothes in tables and files.
const char* clothesName(PeopleClothes clothes);

/// Returns one summary for each scenario, grade, kind of clothes and method in the trials, in order
/// of first occurrence.
std::vector<PeopleSummary> summarize(const std::vector<PeopleTrial>& trials);
/// Returns a number with `digits` decimals for a table; "-" if it is NaN.
std::string tableCell(double value, int digits);
/// Return the header and one row of the table, printed in a terminal, that summarizes a study of
/// people.
std::string peopleTableHeader();
std::string peopleTableRow(const PeopleSummary& summary);
/// Returns the content of runs.csv, with one row per trial.
std::string peopleTrialsCsv(const std::vector<PeopleTrial>& trials);
/// Returns the content of people.csv, with one row per trial and person.
std::string peoplePersonsCsv(const std::vector<PeopleTrial>& trials);

} // namespace dewpoint::experiment
