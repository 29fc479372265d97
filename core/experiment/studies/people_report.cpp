// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/people_report.h"

#include "core/base/units.h"
#include "core/experiment/scenarios/grade.h"
#include "core/experiment/studies/people_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dewpoint::experiment {
namespace {

/// A requirement of the report.
struct Bar {
  std::string words;
  bool isMet = false;
  int runCount = 0; ///< that it was judged by
};

constexpr double kLongestFault = 1.0; ///< seconds that are required
constexpr int kBarRuns = 30;          ///< that the bars are for

/// At least `least` of 30 runs keep everybody's identity.
Bar keeps(const PeopleSummary& one, const std::string& who, int least) {
  return {fmt::format("{}: keeps identities in at least {} of {} runs (here in {} of {})", who,
                      least, kBarRuns, one.keptRunCount, one.runCount),
          one.keptRunCount * kBarRuns >= least * one.runCount, one.runCount};
}

/// What the paper says of motion alone: it mixes people up where MS+C is to keep them.
Bar loses(const PeopleSummary& one, const std::string& who, int least) {
  return {fmt::format("{}: loses identities, that is keeps them in fewer than {} of {} runs (here "
                      "lost in {} of {}, kept in {})",
                      who, least, kBarRuns, one.runCount - one.keptRunCount, one.runCount,
                      one.keptRunCount),
          one.keptRunCount * kBarRuns < least * one.runCount, one.runCount};
}

Bar noFault(const PeopleSummary& one, const std::string& who) {
  return {fmt::format("{}: no ghost and nobody missed for longer than 1 s (at most {:.2f} s and "
                      "{:.2f} s in {} runs)",
                      who, one.longestGhostSeconds, one.longestMissedSeconds, one.runCount),
          one.longestGhostSeconds <= kLongestFault && one.longestMissedSeconds <= kLongestFault,
          one.runCount};
}

std::vector<Bar> barsOf(const std::vector<PeopleSummary>& summaries) {
  // Of kBarRuns; requirements of the people tracker.
  constexpr int kDifferent = 28;
  constexpr int kSimilar = 25;
  std::vector<Bar> bars;
  for (const PeopleSummary& one : summaries) {
    const bool different = one.clothes == PeopleClothes::Different;
    const bool isDewpointMethod = one.method == "people";
    const bool comesAndGoes = one.scenario == "enter-leave";
    if (one.grade == Grade::Wild) {
      continue; // measured; nothing is required of it
    }
    const std::string who = fmt::format("{}, grade {}, {} clothes, {}", one.scenario,
                                        gradeName(one.grade), clothesName(one.clothes), one.method);
    if (!isPeopleScenarioOfPaper(one.scenario)) {
      if (isDewpointMethod) {
        bars.push_back(keeps(one, who, different ? kDifferent : kSimilar));
      }
      continue;
    }
    if (isDewpointMethod && comesAndGoes) {
      bars.push_back(noFault(one, who));
    }
    if (different && (one.method == "mohedano-msc" || (isDewpointMethod && comesAndGoes))) {
      bars.push_back(keeps(one, who, kDifferent));
    }
    if (!different && isDewpointMethod) {
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
  const char* word = bar.isMet ? "yes" : "no";
  return bar.runCount >= kBarRuns ? word : fmt::format("so far {}", word);
}

/// The paper's figure 4(a), of the methods that it compares.
void addCoverage(const std::vector<PeopleSummary>& summaries, FigurePage& page) {
  constexpr double kCovers = 0.8; // recall from which we call a body covered; our choice
  for (const PeopleSummary& motion : summaries) {
    const auto color = std::ranges::find_if(summaries, [&](const PeopleSummary& other) {
      return other.method == "mohedano-msc" && other.clothes == motion.clothes &&
             other.grade == motion.grade;
    });
    if (motion.method != "mohedano-ms" || color == summaries.end() ||
        !isPeopleScenarioOfPaper(motion.scenario)) {
      continue;
    }
    const double all = motion.silhouette.recall;
    const double part = color->silhouette.recall;
    if (std::isnan(all) || std::isnan(part)) {
      continue; // nobody was found
    }
    const auto outcome = !(all > part)   ? ClaimOutcome::NotReproduced
                         : all < kCovers ? ClaimOutcome::InPart
                                         : ClaimOutcome::Reproduced;
    page.addClaim(
        "Figure 4(a): the volume of MS covers the whole body; that of MS+C covers less of it.",
        outcome,
        fmt::format(
            "Here, grade {}, {} clothes: MS covers {} of what is visible of a body, MS+C {} "
            "(a body counts as covered from {:.1f} on).",
            gradeName(motion.grade), clothesName(motion.clothes), tableCell(all, 2),
            tableCell(part, 2), kCovers));
  }
}

/// Heights that people are grouped by, meters.
struct HeightClass {
  double from;
  double to;
  const char* words;
};

/// What the trials of one summary did on the people of one class.
std::vector<std::string> heightRow(const std::vector<PeopleTrial>& trials, const PeopleSummary& one,
                                   const HeightClass& height) {
  int people = 0;
  RunningMean found;
  RunningMean recall;
  RunningMean error;
  for (const PeopleTrial& trial : trials) {
    if (trial.method != one.method || trial.clothes != one.clothes || trial.grade != one.grade) {
      continue;
    }
    for (const PersonResult& person : trial.personResults) {
      if (person.height >= height.from && person.height < height.to) {
        ++people;
        found.add(person.found);
        recall.add(person.silhouette.recall);
        error.add(person.heightError);
      }
    }
  }
  return {gradeName(one.grade),
          clothesName(one.clothes),
          one.method,
          height.words,
          std::to_string(people),
          tableCell(inPercent(found.mean()), 0),
          tableCell(recall.mean(), 2),
          tableCell(inMillimeters(error.mean()), 0)};
}

/// Who is found, by method and height; only where there are people with a child's proportions.
void addHeights(const std::vector<PeopleTrial>& trials, FigurePage& page) {
  static constexpr std::array<HeightClass, 3> kClasses{
      {{0.0, 1.3, "below 1.3 m"}, {1.3, 1.6, "1.3 to 1.6 m"}, {1.6, 3.0, "1.6 m and more"}}};
  const bool anySmall = std::ranges::any_of(trials, [](const PeopleTrial& trial) {
    return std::ranges::any_of(trial.personResults, [](const PersonResult& person) {
      return person.height < simulation::kAdultHeight;
    });
  });
  if (!anySmall) {
    return;
  }
  const auto summaries = summarize(trials);
  std::vector<std::vector<std::string>> rows;
  rows.reserve(summaries.size() * kClasses.size());
  for (const PeopleSummary& one : summaries) {
    for (const HeightClass& height : kClasses) {
      rows.push_back(heightRow(trials, one, height));
    }
  }
  page.addHeading("By height");
  page.addTable({"grade", "clothes", "method", "height", "people", "found %", "silhouette recall",
                 "height error mm"},
                rows);
}

constexpr const char* kHowToRead =
    "A run keeps the identities if all people have the same identity before and after they meet; "
    "in enter-leave, if no identity changes while its person is there. Ghost: how long an estimate "
    "belongs to no person. Missed: how long a person whom two cameras see has no estimate. Both "
    "are the longest of all runs. The requirements are for 30 runs; with fewer runs, the result is "
    "preceded by \"so far\". Found: of the frames in which at least two cameras see a person, the "
    "share in which the person has an estimate. Silhouettes: in every fifth frame, the outline of "
    "each 95 % volume is compared with the visible part of the body in each camera. Recall: the "
    "share of the visible body inside the outline; precision: the share of the outline on the "
    "body; IoU: their intersection over their union. Where the body is hidden, the outline counts "
    "as neither right nor wrong; a carried object is not part of the body.";

constexpr const char* kPictureSentence =
    "The first seed (Mohedano et al. 2009, figures 2 and 4). Left: the four cameras with the "
    "outlines of the 95 % volumes; each identity has a color and a number. Right: the floor from "
    "above, with contours around 25, 50, 75 and 95 % of each person's density; crosses: the true "
    "positions; rings: the cameras. A method that keeps identities shows the same number on the "
    "same person before and after.";

void addPictures(const std::vector<PeopleTrial>& trials, FigurePage& page) {
  bool any = false;
  for (const PeopleTrial& trial : trials) {
    for (std::size_t k = 0; k < trial.pictures.size(); ++k) {
      if (!std::exchange(any, true)) {
        page.addHeading("Volumes and densities");
        page.addParagraph(kPictureSentence);
      }
      page.addJpegImage(fmt::format("{}-{}-{}", clothesName(trial.clothes), trial.method, k + 1),
                        fmt::format("{}, {} clothes: {}", trial.method, clothesName(trial.clothes),
                                    trial.pictures[k].caption),
                        trial.pictures[k].image);
    }
  }
}

/// What the grades of the trials do to the recordings, after a space.
std::string gradesOfTrials(const std::vector<PeopleTrial>& trials) {
  const auto has = [&](Grade grade) {
    return std::ranges::find(trials, grade, &PeopleTrial::grade) != trials.end();
  };
  std::string text;
  if (has(Grade::Ideal)) {
    text += " Grade ideal: images with normal noise, exact time stamps and calibration.";
  }
  if (has(Grade::Room)) {
    text += " Grade room: lenses, sensors, light, time stamps and a manual calibration, as with "
            "fixed cameras in a room; the methods learn the background from the same images.";
  }
  if (has(Grade::Wild)) {
    text += " Grade wild: the same effects, stronger, with different cameras, walls and lamps in "
            "each run.";
  }
  return text;
}

} // namespace

FigurePage peopleReport(const std::string& scenario, const std::vector<PeopleTrial>& trials) {
  const auto summaries = summarize(trials);
  FigurePage page("People: " + scenario,
                  peopleScenarioDescription(scenario) + " Simulated office, 320x240 cameras; " +
                      "mohedano-ms and mohedano-msc are the paper's methods by motion alone and by "
                      "motion and color, people is Dewpoint's own." +
                      gradesOfTrials(trials));
  std::vector<std::vector<std::string>> rows;
  rows.reserve(summaries.size());
  for (const PeopleSummary& one : summaries) {
    rows.push_back({gradeName(one.grade), clothesName(one.clothes), one.method,
                    fmt::format("{} of {}", one.keptRunCount, one.runCount),
                    std::to_string(one.identitySwitches), fmt::format("{:.3f}", one.mota),
                    fmt::format("{:.3f}", one.hota), fmt::format("{:.0f}", inMillimeters(one.motp)),
                    fmt::format("{:.3f}", one.gospa),
                    fmt::format("{:.2f}", one.longestGhostSeconds),
                    fmt::format("{:.2f}", one.longestMissedSeconds),
                    fmt::format("{:.3f}", one.hullVolume), fmt::format("{:.2f}", one.stepMs),
                    tableCell(inPercent(one.found), 0), tableCell(one.silhouette.recall, 2),
                    tableCell(one.silhouette.precision, 2), tableCell(one.silhouette.iou, 2)});
  }
  page.addTable({"grade", "clothes", "method", "identities kept", "switches", "MOTA", "HOTA",
                 "MOTP mm", "GOSPA m", "longest ghost s", "longest missed s", "95 % volume m³",
                 "ms per frame", "found %", "silhouette recall", "precision", "IoU"},
                rows);
  page.addHeading("Expected results, and whether they were reached");
  addCoverage(summaries, page);
  for (const Bar& bar : barsOf(summaries)) {
    page.addRequirement(assessmentOf(bar), bar.isMet, bar.words);
  }
  page.addParagraph(kHowToRead);
  addHeights(trials, page);
  addPictures(trials, page);
  page.addDataFile("runs.csv", peopleTrialsCsv(trials));
  page.addDataFile("people.csv", peoplePersonsCsv(trials));
  return page;
}

} // namespace dewpoint::experiment
