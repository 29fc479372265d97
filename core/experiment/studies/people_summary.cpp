// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/people_summary.h"

#include "core/experiment/metrics/proportion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::experiment {
namespace {

/// A requirement of the report.
struct Bar {
  std::string words;
  bool reached = false;
  int runs = 0; ///< that it was judged by
};

constexpr double kLongestFault = 1.0; ///< seconds
constexpr int kBarRuns = 30;          ///< that the bars are for

/// At least `least` of 30 runs keep everybody's identity.
Bar keeps(const PeopleSummary& one, const std::string& who, int least) {
  return {fmt::format("{}: keeps identities in at least {} of {} runs (here in {} of {})", who,
                      least, kBarRuns, one.kept, one.runs),
          one.kept * kBarRuns >= least * one.runs, one.runs};
}

/// What the paper says of motion alone: it mixes people up where MS+C is to keep them.
Bar loses(const PeopleSummary& one, const std::string& who, int least) {
  return {fmt::format("{}: loses identities, that is keeps them in fewer than {} of {} runs (here "
                      "lost in {} of {}, kept in {})",
                      who, least, kBarRuns, one.runs - one.kept, one.runs, one.kept),
          one.kept * kBarRuns < least * one.runs, one.runs};
}

Bar noFault(const PeopleSummary& one, const std::string& who) {
  return {fmt::format("{}: no ghost and nobody missed for longer than 1 s (at most {:.2f} s and "
                      "{:.2f} s in {} runs)",
                      who, one.longestGhost, one.longestMissed, one.runs),
          one.longestGhost <= kLongestFault && one.longestMissed <= kLongestFault, one.runs};
}

std::vector<Bar> barsOf(const std::vector<PeopleSummary>& summaries) {
  constexpr int kDifferent = 28; // of 30
  constexpr int kSimilar = 25;
  std::vector<Bar> bars;
  for (const PeopleSummary& one : summaries) {
    const bool different = one.clothes == PeopleClothes::Different;
    const bool isOurs = one.method == "people";
    const bool comesAndGoes = one.scenario == "enter-leave";
    const std::string who =
        fmt::format("{}, {} clothes, {}", one.scenario, clothesName(one.clothes), one.method);
    if (isOurs && comesAndGoes) {
      bars.push_back(noFault(one, who));
    }
    if (different && (one.method == "mohedano-msc" || (isOurs && comesAndGoes))) {
      bars.push_back(keeps(one, who, kDifferent));
    }
    if (!different && isOurs) {
      bars.push_back(keeps(one, who, kSimilar));
    }
    if (different && one.method == "mohedano-ms" && one.scenario != "apart" && !comesAndGoes) {
      bars.push_back(loses(one, who, kDifferent));
    }
  }
  return bars;
}

/// Whether a bar is reached; of fewer runs than it is for, only how it looks.
std::string assessmentOf(const Bar& bar) {
  const char* word = bar.reached ? "yes" : "no";
  return bar.runs >= kBarRuns ? word : fmt::format("so far {}", word);
}

constexpr const char* kHowToRead =
    "Identities are kept when everybody has the same one before people meet and after it; in "
    "enter-leave, when nobody's changes while they are there. Ghost: how long an estimate belongs "
    "to nobody; missed: how long somebody whom two cameras see has none; the longest of all runs. "
    "The bars are for 30 runs: of fewer, \"so far\" says how it looks.";

constexpr const char* kPictureSentence =
    "The first seed (Mohedano et al. 2009, figures 2 and 4). Left: the four cameras with the "
    "outlines of the 95 % volumes, a color and a number for each identity. Right: the floor from "
    "above, with level curves around 25, 50, 75 and 95 % of each person's density; crosses: where "
    "people are in truth; rings: the cameras. A method that keeps identities shows the same number "
    "on the same person before and after.";

void addPictures(const std::vector<PeopleTrial>& trials, FigurePage& page) {
  bool any = false;
  for (const PeopleTrial& trial : trials) {
    for (std::size_t k = 0; k < trial.pictures.size(); ++k) {
      if (!std::exchange(any, true)) {
        page.heading("Volumes and densities");
        page.paragraph(kPictureSentence);
      }
      page.photo(fmt::format("{}-{}-{}", clothesName(trial.clothes), trial.method, k + 1),
                 fmt::format("{}, {} clothes: {}", trial.method, clothesName(trial.clothes),
                             trial.pictures[k].words),
                 trial.pictures[k].image);
    }
  }
}

} // namespace

const char* clothesName(PeopleClothes clothes) {
  return clothes == PeopleClothes::Different ? "different" : "similar";
}

std::vector<PeopleSummary> summarize(const std::vector<PeopleTrial>& trials) {
  std::vector<PeopleSummary> all;
  std::vector<int> matched;
  for (const PeopleTrial& trial : trials) {
    auto found = std::ranges::find_if(all, [&](const PeopleSummary& one) {
      return one.scenario == trial.scenario && one.clothes == trial.clothes &&
             one.method == trial.method;
    });
    if (found == all.end()) {
      PeopleSummary fresh;
      fresh.scenario = trial.scenario;
      fresh.clothes = trial.clothes;
      fresh.method = trial.method;
      found = all.insert(all.end(), fresh);
      matched.push_back(0);
    }
    PeopleSummary& sum = *found;
    ++sum.runs;
    sum.kept += trial.kept ? 1 : 0;
    sum.identitySwitches += trial.identitySwitches;
    const double share = 1.0 / sum.runs;
    sum.mota += share * (trial.mota - sum.mota);
    sum.hota += share * (trial.hota - sum.hota);
    sum.gospa += share * (trial.gospa - sum.gospa);
    sum.hullVolume += share * (trial.hullVolume - sum.hullVolume);
    sum.stepMs += share * (trial.stepMs - sum.stepMs);
    if (!std::isnan(trial.motp)) {
      int& count = matched[static_cast<std::size_t>(found - all.begin())];
      sum.motp += (trial.motp - sum.motp) / ++count;
    }
    sum.longestGhost = std::max(sum.longestGhost, trial.longestGhost);
    sum.longestMissed = std::max(sum.longestMissed, trial.longestMissed);
  }
  return all;
}

std::string peopleTableHead() {
  return fmt::format("{:<14} {:<9} {:<13} {:>7} {:>13} {:>6} {:>6} {:>6} {:>7} {:>7} {:>6} {:>6} "
                     "{:>6} {:>6}",
                     "scenario", "clothes", "method", "kept", "95 %", "switch", "MOTA", "HOTA",
                     "MOTP mm", "GOSPA m", "ghost", "missed", "m3", "ms");
}

std::string peopleTableRow(const PeopleSummary& one) {
  const Interval interval = wilsonInterval({one.kept, one.runs});
  return fmt::format("{:<14} {:<9} {:<13} {:>3}/{:<3} {:>5.0f}..{:<4.0f} % {:>6} {:>6.3f} {:>6.3f} "
                     "{:>7.0f} {:>7.3f} {:>6.2f} {:>6.2f} {:>6.3f} {:>6.2f}",
                     one.scenario, clothesName(one.clothes), one.method, one.kept, one.runs,
                     100.0 * interval.low, 100.0 * interval.high, one.identitySwitches, one.mota,
                     one.hota, 1000.0 * one.motp, one.gospa, one.longestGhost, one.longestMissed,
                     one.hullVolume, one.stepMs);
}

std::string peopleTrialsCsv(const std::vector<PeopleTrial>& trials) {
  std::string text = "scenario,clothes,method,seed,kept,mota,motp_m,hota,gospa_m,identity_switches,"
                     "longest_ghost_s,longest_missed_s,hull_volume_m3,step_ms\n";
  for (const PeopleTrial& one : trials) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", one.scenario,
                        clothesName(one.clothes), one.method, one.seed, one.kept ? 1 : 0, one.mota,
                        one.motp, one.hota, one.gospa, one.identitySwitches, one.longestGhost,
                        one.longestMissed, one.hullVolume, one.stepMs);
  }
  return text;
}

FigurePage peopleReport(const std::string& scenario, const std::vector<PeopleTrial>& trials) {
  const auto summaries = summarize(trials);
  FigurePage page("People: " + scenario,
                  peopleScenarioSentence(scenario) + " Simulated office, four 320x240 cameras; " +
                      "mohedano-ms and mohedano-msc are the paper's methods by motion alone and "
                      "by motion and color, people is our own.");
  std::vector<std::vector<std::string>> rows;
  rows.reserve(summaries.size());
  for (const PeopleSummary& one : summaries) {
    rows.push_back({clothesName(one.clothes), one.method,
                    fmt::format("{} of {}", one.kept, one.runs),
                    std::to_string(one.identitySwitches), fmt::format("{:.3f}", one.mota),
                    fmt::format("{:.3f}", one.hota), fmt::format("{:.0f}", 1000.0 * one.motp),
                    fmt::format("{:.3f}", one.gospa), fmt::format("{:.2f}", one.longestGhost),
                    fmt::format("{:.2f}", one.longestMissed), fmt::format("{:.3f}", one.hullVolume),
                    fmt::format("{:.2f}", one.stepMs)});
  }
  page.table({"clothes", "method", "identities kept", "switches", "MOTA", "HOTA", "MOTP mm",
              "GOSPA m", "longest ghost s", "longest missed s", "95 % volume m³", "ms per frame"},
             rows);
  page.heading("What is expected, and whether it came out");
  for (const Bar& bar : barsOf(summaries)) {
    page.bar(assessmentOf(bar), bar.reached, bar.words);
  }
  page.paragraph(kHowToRead);
  addPictures(trials, page);
  page.data("runs.csv", peopleTrialsCsv(trials));
  return page;
}

} // namespace dewpoint::experiment
