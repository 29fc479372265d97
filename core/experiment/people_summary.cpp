// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/people_summary.h"

#include "core/base/markup.h"
#include "core/experiment/proportion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint {
namespace {

/// A bar of the report: of so many runs, at least (or at most) this share keeps identities.
struct Bar {
  std::string words;
  bool reached = false;
};

constexpr double kLongestFault = 1.0; ///< seconds

std::vector<Bar> barsOf(const std::vector<PeopleSummary>& summaries) {
  std::vector<Bar> bars;
  for (const PeopleSummary& one : summaries) {
    const double share = static_cast<double>(one.kept) / std::max(1, one.runs);
    const bool different = one.clothes == PeopleClothes::Different;
    const std::string who =
        fmt::format("{}, {} clothes, {}", one.scenario, clothesName(one.clothes), one.method);
    if (one.scenario == "enter-leave") {
      if (one.method == "people") {
        bars.push_back({fmt::format("{}: no ghost and nobody missed for longer than 1 s ({:.2f} s, "
                                    "{:.2f} s)",
                                    who, one.longestGhost, one.longestMissed),
                        one.longestGhost <= kLongestFault && one.longestMissed <= kLongestFault});
      }
    } else if (one.method == "mohedano-msc" && different) {
      bars.push_back(
          {fmt::format("{}: keeps at least 28 of 30 ({} of {})", who, one.kept, one.runs),
           share >= 28.0 / 30.0});
    } else if (one.method == "mohedano-ms" && different && one.scenario != "apart") {
      bars.push_back({fmt::format("{}: loses identities ({} of {} kept)", who, one.kept, one.runs),
                      share < 28.0 / 30.0});
    } else if (one.method == "people" && !different) {
      bars.push_back(
          {fmt::format("{}: keeps at least 25 of 30 ({} of {})", who, one.kept, one.runs),
           share >= 25.0 / 30.0});
    }
  }
  return bars;
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

std::string peopleReportHtml(const std::string& scenario, const std::vector<PeopleTrial>& trials) {
  const auto summaries = summarize(trials);
  std::string html =
      fmt::format("<!doctype html><html lang='en'><meta charset='utf-8'><title>{0}</title>"
                  "<style>body{{font:15px sans-serif;max-width:75em;margin:2em auto}}"
                  "td,th{{padding:.2em .7em;text-align:right}}.no{{color:#b00020}}</style>"
                  "<h1>People: {0}</h1><p>{1} Simulated office, four 320x240 cameras. Version {2}."
                  "</p><table><tr>",
                  escaped(scenario), escaped(peopleScenarioSentence(scenario)), DEWPOINT_VERSION);
  for (const char* head :
       {"clothes", "method", "identities kept", "switches", "MOTA", "HOTA", "MOTP mm", "GOSPA m",
        "longest ghost s", "longest missed s", "95 % volume m³", "ms per frame"}) {
    html += fmt::format("<th>{}</th>", head);
  }
  html += "</tr>";
  for (const PeopleSummary& one : summaries) {
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{} of {}</td><td>{}</td><td>{:.3f}</td>"
                        "<td>{:.3f}</td><td>{:.0f}</td><td>{:.3f}</td><td>{:.2f}</td><td>{:.2f}"
                        "</td><td>{:.3f}</td><td>{:.2f}</td></tr>",
                        clothesName(one.clothes), one.method, one.kept, one.runs,
                        one.identitySwitches, one.mota, one.hota, 1000.0 * one.motp, one.gospa,
                        one.longestGhost, one.longestMissed, one.hullVolume, one.stepMs);
  }
  html += "</table><h2>What is expected, and whether it came out</h2><ul>";
  for (const Bar& bar : barsOf(summaries)) {
    html += fmt::format("<li{}>{}: {}</li>", bar.reached ? "" : " class='no'", escaped(bar.words),
                        bar.reached ? "yes" : "no");
  }
  return html + "</ul></html>\n";
}

} // namespace dewpoint
