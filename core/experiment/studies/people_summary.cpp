// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/people_summary.h"

#include "core/base/units.h"
#include "core/experiment/metrics/proportion.h"
#include "core/experiment/scenarios/grade.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::experiment {
namespace {

/// Means over runs of what they say of all people.
struct EverybodyMean {
  RunningMean found;
  RunningMean recall;
  RunningMean precision;
  RunningMean iou;

  void add(const PersonResult& allPersonsResult) {
    found.add(allPersonsResult.found);
    recall.add(allPersonsResult.silhouette.recall);
    precision.add(allPersonsResult.silhouette.precision);
    iou.add(allPersonsResult.silhouette.iou);
  }
};

} // namespace

const char* clothesName(PeopleClothes clothes) {
  return clothes == PeopleClothes::Different ? "different" : "similar";
}

std::vector<PeopleSummary> summarize(const std::vector<PeopleTrial>& trials) {
  std::vector<PeopleSummary> all;
  std::vector<int> matched;
  std::vector<EverybodyMean> silhouettes;
  for (const PeopleTrial& trial : trials) {
    auto found = std::ranges::find_if(all, [&](const PeopleSummary& one) {
      return one.scenario == trial.scenario && one.grade == trial.grade &&
             one.clothes == trial.clothes && one.method == trial.method;
    });
    if (found == all.end()) {
      PeopleSummary fresh;
      fresh.scenario = trial.scenario;
      fresh.grade = trial.grade;
      fresh.clothes = trial.clothes;
      fresh.method = trial.method;
      found = all.insert(all.end(), fresh);
      matched.push_back(0);
      silhouettes.emplace_back();
    }
    PeopleSummary& sum = *found;
    ++sum.runCount;
    sum.keptRunCount += trial.hasKeptIdentities ? 1 : 0;
    sum.identitySwitches += trial.identitySwitches;
    const double share = 1.0 / sum.runCount;
    sum.mota += share * (trial.mota - sum.mota);
    sum.hota += share * (trial.hota - sum.hota);
    sum.gospa += share * (trial.gospa - sum.gospa);
    sum.hullVolume += share * (trial.hullVolume - sum.hullVolume);
    sum.stepMs += share * (trial.stepMs - sum.stepMs);
    if (!std::isnan(trial.motp)) {
      int& count = matched[static_cast<std::size_t>(found - all.begin())];
      sum.motp += (trial.motp - sum.motp) / ++count;
    }
    silhouettes[static_cast<std::size_t>(found - all.begin())].add(trial.allPersonsResult);
    sum.longestGhostSeconds = std::max(sum.longestGhostSeconds, trial.longestGhostSeconds);
    sum.longestMissedSeconds = std::max(sum.longestMissedSeconds, trial.longestMissedSeconds);
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].found = silhouettes[k].found.mean();
    all[k].silhouette = {silhouettes[k].recall.mean(), silhouettes[k].precision.mean(),
                         silhouettes[k].iou.mean()};
  }
  return all;
}

std::string tableCell(double value, int digits) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value, digits);
}

std::string peopleTableHeader() {
  return fmt::format(
      "{:<17} {:<5} {:<9} {:<13} {:>7} {:>13} {:>6} {:>6} {:>6} {:>7} {:>7} {:>6} {:>6} "
      "{:>6} {:>6} {:>6} {:>6} {:>6} {:>6}",
      "scenario", "grade", "clothes", "method", "kept", "95 %", "switch", "MOTA", "HOTA", "MOTP mm",
      "GOSPA m", "ghost", "missed", "m3", "ms", "found", "recall", "prec", "IoU");
}

std::string peopleTableRow(const PeopleSummary& one) {
  const Interval interval = wilsonInterval({one.keptRunCount, one.runCount});
  return fmt::format(
      "{:<17} {:<5} {:<9} {:<13} {:>3}/{:<3} {:>5.0f}..{:<4.0f} % {:>6} {:>6.3f} {:>6.3f} "
      "{:>7.0f} {:>7.3f} {:>6.2f} {:>6.2f} {:>6.3f} {:>6.2f} {:>6} {:>6} {:>6} {:>6}",
      one.scenario, gradeName(one.grade), clothesName(one.clothes), one.method, one.keptRunCount,
      one.runCount, inPercent(interval.low), inPercent(interval.high), one.identitySwitches,
      one.mota, one.hota, inMillimeters(one.motp), one.gospa, one.longestGhostSeconds,
      one.longestMissedSeconds, one.hullVolume, one.stepMs, tableCell(one.found, 3),
      tableCell(one.silhouette.recall, 3), tableCell(one.silhouette.precision, 3),
      tableCell(one.silhouette.iou, 3));
}

std::string peopleTrialsCsv(const std::vector<PeopleTrial>& trials) {
  std::string text =
      "scenario,grade,clothes,method,seed,kept,mota,motp_m,hota,gospa_m,identity_switches,"
      "longest_ghost_s,longest_missed_s,hull_volume_m3,step_ms,found,"
      "silhouette_recall,silhouette_precision,silhouette_iou\n";
  for (const PeopleTrial& one : trials) {
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", one.scenario,
        gradeName(one.grade), clothesName(one.clothes), one.method, one.seed,
        one.hasKeptIdentities ? 1 : 0, one.mota, one.motp, one.hota, one.gospa,
        one.identitySwitches, one.longestGhostSeconds, one.longestMissedSeconds, one.hullVolume,
        one.stepMs, one.allPersonsResult.found, one.allPersonsResult.silhouette.recall,
        one.allPersonsResult.silhouette.precision, one.allPersonsResult.silhouette.iou);
  }
  return text;
}

std::string peoplePersonsCsv(const std::vector<PeopleTrial>& trials) {
  std::string text = "scenario,grade,clothes,method,seed,person,height_m,found,silhouette_recall,"
                     "silhouette_precision,silhouette_iou,height_error_m\n";
  for (const PeopleTrial& one : trials) {
    for (std::size_t k = 0; k < one.personResults.size(); ++k) {
      const PersonResult& person = one.personResults[k];
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", one.scenario,
                          gradeName(one.grade), clothesName(one.clothes), one.method, one.seed,
                          k + 1, person.height, person.found, person.silhouette.recall,
                          person.silhouette.precision, person.silhouette.iou, person.heightError);
    }
  }
  return text;
}

} // namespace dewpoint::experiment
