// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/progress.h"
#include "app/dewpoint-cli/experiment/experiment_commands.h"
#include "app/dewpoint-cli/simulate/record_office.h"
#include "core/experiment/report/report_folder.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/scenarios/grade.h"
#include "core/experiment/studies/people_series.h"
#include "core/experiment/studies/people_summary.h"
#include "core/tracking/catalog/method_catalog.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace dewpoint::app {
namespace {

struct StudyOptions {
  std::string scenario;
  std::optional<std::uint64_t> seed; ///< the first one
  int seeds = 30;
  std::string clothes = "both";
  std::string grade = "ideal";
  std::vector<std::string> methods;
  std::vector<std::string> settings;
  std::string folder;
  std::string record;
};

Error ofSettings(Error error) {
  error.file = "--set";
  return error;
}

Result<PeopleStudySetup> setupOf(const StudyOptions& options) {
  PeopleStudySetup setup;
  setup.scenario = options.scenario;
  setup.grade = gradeFromName(options.grade).value_or(Grade::Ideal); // names are checked
  if (!options.methods.empty()) {
    setup.methods = options.methods;
  }
  for (const std::string& setting : options.settings) {
    const auto equals = setting.find('=');
    char* end = nullptr;
    const double value =
        equals == std::string::npos ? 0.0 : std::strtod(setting.c_str() + equals + 1, &end);
    if (end == nullptr || *end != '\0') {
      return failure(ErrorCode::BadValue, "", "--set", setting + " is not key=number");
    }
    setup.parameters.emplace_back(setting.substr(0, equals), value);
  }
  return checkPeopleParameters(setup).map_error(ofSettings).map([&] { return setup; });
}

int recordScenario(const StudyOptions& options) {
  const auto clothes = options.clothes == clothesName(PeopleClothes::Similar)
                           ? PeopleClothes::Similar
                           : PeopleClothes::Different;
  const auto scenario =
      makePeopleScenario(options.scenario, clothes, options.seed.value_or(kFirstTuningSeed));
  return scenario ? recordOffice(scenario->scene, options.record, "--record")
                  : reportError(scenario.error());
}

int studyScenario(const StudyOptions& options) {
  auto setup = setupOf(options);
  if (!setup) {
    reportError(setup.error());
    return kExitUsage;
  }
  if (!options.folder.empty()) {
    if (const auto folder = prepareReportFolder(options.folder); !folder) {
      return reportError(folder.error());
    }
  }
  catchInterruption();
  std::vector<PeopleClothes> clothes;
  for (const auto kind : {PeopleClothes::Different, PeopleClothes::Similar}) {
    if (options.clothes == "both" || options.clothes == clothesName(kind)) {
      clothes.push_back(kind);
    }
  }
  setup->seed = options.seed.value_or(kFirstReportingSeed);
  Progress progress("people-" + options.scenario,
                    options.seeds * static_cast<std::int64_t>(clothes.size()));
  const auto trials =
      studyPeopleSeries(*setup, clothes, options.seeds, [&](std::int64_t done, std::int64_t) {
        progress.show(done);
        return !wasInterruptionRequested();
      });
  progress.finish();
  if (!trials) {
    return reportError(trials.error());
  }
  fmt::print("{}\n", peopleTableHeader());
  for (const PeopleSummary& summary : summarize(*trials)) {
    fmt::print("{}\n", peopleTableRow(summary));
  }
  fmt::print("Seeds {}.\n", describeSeeds(setup->seed, options.seeds));
  if (!options.folder.empty()) {
    if (const auto written = writePeopleStudy(options.scenario, *trials, options.folder);
        !written) {
      return reportError(written.error());
    }
  }
  return wasInterruptionRequested() ? kExitInterrupted : kExitDone;
}

} // namespace

void addPeopleExperiments(CLI::App& group, int& exitCode) {
  for (const std::string& scenario : peopleScenarioNames()) {
    auto* command = group.add_subcommand(
        "people-" + scenario, "Simulated office: " + peopleScenarioDescription(scenario));
    command->alias(scenario);
    auto options = std::make_shared<StudyOptions>();
    options->scenario = scenario;
    command->add_option("--seed", options->seed,
                        fmt::format("The first seed (default: {}, with --record {})",
                                    kFirstReportingSeed, kFirstTuningSeed));
    command->add_option("--seeds", options->seeds, "Number of seeds")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    command->add_option("--clothes", options->clothes, "Clothes: different, similar or both")
        ->check(CLI::IsMember({"different", "similar", "both"}))
        ->capture_default_str();
    command
        ->add_option("--grade", options->grade,
                     "Quality of images, time stamps and calibration: ideal, room or wild")
        ->check(CLI::IsMember({"ideal", "room", "wild"}))
        ->capture_default_str();
    command->add_option("--method", options->methods, "Method; all if omitted")
        ->delimiter(',')
        ->check(CLI::IsMember(PeopleStudySetup().methods));
    command->add_option("--set", options->settings,
                        "Set a parameter of the methods that have it: key=value");
    command->add_option("--out", options->folder,
                        "Folder for report.html, its pictures, runs.csv and people.csv; created if "
                        "it does not exist");
    command
        ->add_option("--record", options->record,
                     "Only write the scene of --seed to this folder, as a project with grade ideal")
        ->excludes("--set", "--method", "--out", "--seeds", "--grade");
    command->callback([options, &exitCode] {
      exitCode = options->record.empty() ? studyScenario(*options) : recordScenario(*options);
    });
  }
}

} // namespace dewpoint::app
