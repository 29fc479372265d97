// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/study_experiments.h"

#include "core/experiment/report/report_folder.h"
#include "core/experiment/studies/people_series.h"
#include "core/experiment/studies/sugandi_report.h"
#include "core/experiment/studies/sugandi_study.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace dewpoint::experiment {
namespace {

constexpr double kContenders = 7.0; ///< of studyBoxes(), per clip

Status sugandiRmse(const ExperimentOptions& options) {
  if (const auto folder = prepareReportFolder(options.outputFolder, kBoxReport); !folder) {
    return folder;
  }
  std::vector<BoxClip> clips{simulatedBoxClip(options.firstSeed)};
  if (!options.recordingsFolder.empty()) {
    auto recorded = recordedBoxClips(options.recordingsFolder);
    if (!recorded) {
      return tl::make_unexpected(recorded.error());
    }
    if (recorded->empty()) {
      return failure(ErrorCode::NotFound, options.recordingsFolder.string(), "",
                     "the folder contains neither juggle1 nor otb");
    }
    std::ranges::move(*recorded, std::back_inserter(clips));
  }
  double rows = 0.0;
  const double all = kContenders * static_cast<double>(clips.size());
  const auto goOn = [&](double part) { return !options.progress || options.progress(part); };
  if (!goOn(0.0)) {
    return failure(ErrorCode::Canceled, "", "", "");
  }
  const auto study = studyBoxes(
      clips, std::max(1, options.runCount),
      [&](const BoxStudyRow&) { return goOn(std::min(1.0, ++rows / all)); }, options.firstSeed);
  if (!study) {
    return tl::make_unexpected(study.error());
  }
  return writeBoxStudy(*study, options.outputFolder);
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
  if (const auto folder = prepareReportFolder(options.outputFolder); !folder) {
    return folder;
  }
  PeopleStudySetup setup;
  setup.scenario = scenario;
  setup.seed = options.firstSeed;
  bool goOn = true;
  const auto trials =
      studyPeopleSeries(setup, clothesOf(options.clothes), std::max(1, options.runCount),
                        [&](std::int64_t done, std::int64_t all) {
                          goOn = !options.progress || options.progress(double(done) / double(all));
                          return goOn;
                        });
  if (!trials) {
    return tl::make_unexpected(trials.error());
  }
  return goOn ? writePeopleStudy(scenario, *trials, options.outputFolder)
              : failure(ErrorCode::Canceled, "", "", "");
}

/// A scene of people. `name` begins with "people-".
FigureExperiment sceneOfPeople(std::string_view name, std::string_view title,
                               std::string_view sentence,
                               Status (*run)(const ExperimentOptions& options),
                               ExperimentGroup group = ExperimentGroup::People) {
  return {.name = name,
          .title = title,
          .description = sentence,
          .runCount = 3,
          .run = run,
          .hasClothesOption = true,
          .group = group};
}

} // namespace

std::span<const FigureExperiment> boxAndPeopleExperiments() {
  static const std::array kAll{
      FigureExperiment{
          .name = "sugandi-rmse",
          .title = "Box tracking: error, success and precision",
          .description =
              "Sugandi et al. 2009, section 4: compares method sugandi with 100 and with 300 "
              "particles, method histogram, and four trackers of OpenCV, all on the same clips.",
          .runCount = 2,
          .run = &sugandiRmse,
          .reportFile = kBoxReport,
          .usesRecordings = true,
          .group = ExperimentGroup::Sugandi},
      sceneOfPeople(
          "people-crossing", "People whose paths cross",
          "Mohedano et al. 2009: two people meet and walk on. A method that uses only motion may "
          "mix them up; color tells them apart if their clothes differ.",
          [](const ExperimentOptions& options) { return studyScenario("crossing", options); },
          ExperimentGroup::Mohedano),
      sceneOfPeople(
          "people-meet-and-turn", "People who meet and turn back",
          "Mohedano et al. 2009: two people meet, stop and walk back.",
          [](const ExperimentOptions& options) { return studyScenario("meet-and-turn", options); },
          ExperimentGroup::Mohedano),
      sceneOfPeople(
          "people-side-by-side", "People side by side",
          "Mohedano et al. 2009: two people walk close to each other.",
          [](const ExperimentOptions& options) { return studyScenario("side-by-side", options); },
          ExperimentGroup::Mohedano),
      sceneOfPeople(
          "people-enter-leave", "People who enter and leave",
          "Mohedano et al. 2009: people enter and leave. Measures how long an estimate exists "
          "where nobody is, and how long a person has no estimate.",
          [](const ExperimentOptions& options) { return studyScenario("enter-leave", options); },
          ExperimentGroup::Mohedano),
      sceneOfPeople(
          "people-apart", "People who stay apart",
          "Mohedano et al. 2009: two people far apart. This is the easy case: no method should mix "
          "them up.",
          [](const ExperimentOptions& options) { return studyScenario("apart", options); },
          ExperimentGroup::Mohedano),
      sceneOfPeople(
          "people-heights", "People of different heights",
          "Three people walk about: a child 0.9 to 1.3 m tall, a person 1.3 to 1.6 m tall and a "
          "person 1.88 to 2 m tall.",
          [](const ExperimentOptions& options) { return studyScenario("heights", options); }),
      sceneOfPeople(
          "people-sitting", "People who sit and crouch",
          "One person sits down on a stool and rises, one crouches and rises, and one walks by.",
          [](const ExperimentOptions& options) { return studyScenario("sitting", options); }),
      sceneOfPeople(
          "people-carrying", "People who carry objects",
          "Two people walk past each other, one with a box in front of the chest, one with a bag.",
          [](const ExperimentOptions& options) { return studyScenario("carrying", options); }),
      sceneOfPeople(
          "people-crowd", "A crowd",
          "Five to eight people walk about for 12 s; their paths may touch and cross.",
          [](const ExperimentOptions& options) { return studyScenario("crowd", options); }),
      sceneOfPeople(
          "people-two-cameras", "People seen by two cameras",
          "Two people walk past each other, seen by only two of the four cameras.",
          [](const ExperimentOptions& options) { return studyScenario("two-cameras", options); }),
      sceneOfPeople(
          "people-contact", "People who come close to each other",
          "Two people come within 0.15 to 0.28 m of each other, stand there, and go back.",
          [](const ExperimentOptions& options) { return studyScenario("contact", options); }),
      sceneOfPeople(
          "people-furniture-moved", "Furniture that moves",
          "A cabinet and a stool are moved after the cameras have learned the background.",
          [](const ExperimentOptions& options) {
            return studyScenario("furniture-moved", options);
          }),
      sceneOfPeople(
          "people-room-clothes", "Clothes in the room's colors",
          "Two people whose clothes have the colors of walls, furniture and floor walk past each "
          "other.",
          [](const ExperimentOptions& options) { return studyScenario("room-clothes", options); }),
      sceneOfPeople("people-patterned-clothes", "Patterned clothes",
                    "Two people in striped, checked or blotched shirts walk past each other.",
                    [](const ExperimentOptions& options) {
                      return studyScenario("patterned-clothes", options);
                    }),
  };
  return kAll;
}

} // namespace dewpoint::experiment
