// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/study_experiments.h"

#include "core/experiment/report/report_folder.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/studies/sugandi_report.h"
#include "core/experiment/studies/sugandi_study.h"
#include "core/tracking/catalog/method_catalog.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

namespace dewpoint::experiment {
namespace {

constexpr double kContenders = 7.0; ///< of studyBoxes(), per clip

Status sugandiRmse(const ExperimentOptions& options) {
  if (const auto folder = prepareReportFolder(options.folder, kBoxReport); !folder) {
    return folder;
  }
  std::vector<BoxClip> clips{simulatedBoxClip(options.firstSeed)};
  if (!options.recordings.empty()) {
    auto recorded = recordedBoxClips(options.recordings);
    if (!recorded) {
      return tl::make_unexpected(recorded.error());
    }
    if (recorded->empty()) {
      return failure(ErrorCode::NotFound, options.recordings.string(), "",
                     "neither juggle1 nor otb is there");
    }
    std::ranges::move(*recorded, std::back_inserter(clips));
  }
  double rows = 0.0;
  const double all = kContenders * static_cast<double>(clips.size());
  const auto goOn = [&](double part) { return !options.progress || options.progress(part); };
  if (!goOn(0.0)) {
    return failure(ErrorCode::Cancelled, "", "", "");
  }
  const auto study = studyBoxes(
      clips, std::max(1, options.runs),
      [&](const BoxRow&) { return goOn(std::min(1.0, ++rows / all)); }, options.firstSeed);
  if (!study) {
    return tl::make_unexpected(study.error());
  }
  return writeBoxStudy(*study, options.folder);
}

std::vector<PeopleClothes> clothesOf(StudyClothes wanted) {
  switch (wanted) {
  case StudyClothes::Different:
    return {PeopleClothes::Different};
  case StudyClothes::Similar:
    return {PeopleClothes::Similar};
  case StudyClothes::Both:
    break;
  }
  return {PeopleClothes::Different, PeopleClothes::Similar};
}

Status studyScenario(const char* scenario, const ExperimentOptions& options) {
  if (const auto folder = prepareReportFolder(options.folder); !folder) {
    return folder;
  }
  PeopleStudySetup setup;
  setup.scenario = scenario;
  setup.seed = options.firstSeed;
  bool goOn = true;
  const auto trials =
      studyManyPeople(setup, clothesOf(options.clothes), std::max(1, options.runs),
                      [&](std::int64_t done, std::int64_t all) {
                        goOn = !options.progress || options.progress(double(done) / double(all));
                        return goOn;
                      });
  if (!trials) {
    return tl::make_unexpected(trials.error());
  }
  return goOn ? writePeopleStudy(scenario, *trials, options.folder)
              : failure(ErrorCode::Cancelled, "", "", "");
}

Status peopleCrossing(const ExperimentOptions& options) {
  return studyScenario("crossing", options);
}
Status peopleMeetAndTurn(const ExperimentOptions& options) {
  return studyScenario("meet-and-turn", options);
}
Status peopleSideBySide(const ExperimentOptions& options) {
  return studyScenario("side-by-side", options);
}
Status peopleEnterLeave(const ExperimentOptions& options) {
  return studyScenario("enter-leave", options);
}
Status peopleApart(const ExperimentOptions& options) {
  return studyScenario("apart", options);
}

} // namespace

std::span<const FigureExperiment> studyExperiments() {
  static const std::array kAll{
      FigureExperiment{.name = "sugandi-rmse",
                       .title = "Boxes: error, success and precision",
                       .sentence = "Sugandi et al. 2009, section 4: 100 and 300 particles, method "
                                   "histogram and four trackers of OpenCV on the same clips.",
                       .runs = 2,
                       .run = &sugandiRmse,
                       .report = kBoxReport,
                       .takesRecordings = true},
      FigureExperiment{.name = "people-crossing",
                       .title = "People who cross",
                       .sentence = "Mohedano et al. 2009: two people meet and walk on; by motion "
                                   "alone they are mixed up, with color they are not.",
                       .runs = 3,
                       .run = &peopleCrossing,
                       .takesClothes = true},
      FigureExperiment{.name = "people-meet-and-turn",
                       .title = "People who meet and turn",
                       .sentence = "Mohedano et al. 2009: two people meet, stay and go back where "
                                   "they came from.",
                       .runs = 3,
                       .run = &peopleMeetAndTurn,
                       .takesClothes = true},
      FigureExperiment{.name = "people-side-by-side",
                       .title = "People side by side",
                       .sentence = "Mohedano et al. 2009: two people walk close to each other.",
                       .runs = 3,
                       .run = &peopleSideBySide,
                       .takesClothes = true},
      FigureExperiment{.name = "people-enter-leave",
                       .title = "People who enter and leave",
                       .sentence = "Mohedano et al. 2009: people come and go; how long nobody is "
                                   "taken for somebody, or somebody for nobody.",
                       .runs = 3,
                       .run = &peopleEnterLeave,
                       .takesClothes = true},
      FigureExperiment{.name = "people-apart",
                       .title = "People who stay apart",
                       .sentence = "Mohedano et al. 2009: two people far from each other, the easy "
                                   "case, in which no method may mix them up.",
                       .runs = 3,
                       .run = &peopleApart,
                       .takesClothes = true},
  };
  return kAll;
}

Result<std::vector<PeopleTrial>>
studyManyPeople(PeopleStudySetup setup, const std::vector<PeopleClothes>& clothes, int seeds,
                const std::function<bool(std::int64_t done, std::int64_t all)>& progress) {
  simulation::ViewCache views;
  std::vector<PeopleTrial> trials;
  const std::uint64_t first = setup.seed;
  const std::int64_t all = seeds * static_cast<std::int64_t>(clothes.size());
  std::int64_t done = 0;
  bool goOn = progress(0, all);
  for (const PeopleClothes kind : clothes) {
    setup.clothes = kind;
    for (int k = 0; k < seeds && goOn; ++k) {
      setup.seed = first + static_cast<std::uint64_t>(k);
      setup.pictures = k == 0;
      const auto more = studyPeople(setup, views);
      if (!more) {
        return tl::make_unexpected(more.error());
      }
      trials.insert(trials.end(), more->begin(), more->end());
      goOn = progress(++done, all);
    }
  }
  return trials;
}

Status writePeopleStudy(const std::string& scenario, const std::vector<PeopleTrial>& trials,
                        const std::filesystem::path& folder) {
  std::set<std::uint64_t> seeds;
  for (const PeopleTrial& trial : trials) {
    seeds.insert(trial.seed);
  }
  FigurePage page = peopleReport(scenario, trials);
  page.paragraph("Seeds " + seedSentence({seeds.begin(), seeds.end()}) + ".");
  return page.write(folder);
}

} // namespace dewpoint::experiment
