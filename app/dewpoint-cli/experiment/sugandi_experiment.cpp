// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/experiment/experiment_commands.h"
#include "core/experiment/report/report_folder.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/studies/sugandi_report.h"
#include "core/experiment/studies/sugandi_study.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

namespace dewpoint::app {
namespace {

struct SugandiOptions {
  std::filesystem::path folder;
  std::filesystem::path data;
  std::uint64_t scene = kFirstReportingSeed;
  std::uint64_t first = kFirstReportingSeed;
  int seeds = 5;
  bool perturbed = false;
};

int studySugandi(const SugandiOptions& options) {
  if (const auto folder = prepareReportFolder(options.folder, kBoxReport); !folder) {
    return reportError(folder.error());
  }
  std::vector<BoxClip> clips{simulatedBoxClip(options.scene)};
  if (!options.data.empty()) {
    auto recorded = recordedBoxClips(options.data);
    if (!recorded) {
      return reportError(recorded.error());
    }
    if (recorded->empty()) {
      return reportError({ErrorCode::NotFound, options.data.string(), "--data",
                          "the folder contains neither juggle1 nor otb"});
    }
    std::ranges::move(*recorded, std::back_inserter(clips));
  }
  catchInterruption();
  const auto measured = [](const BoxStudyRow& row) {
    fmt::print(stderr, "{}: {}\n", row.clip, row.method);
    return !wasInterruptionRequested();
  };
  auto study = studyBoxes(clips, options.seeds, measured, options.first);
  if (!study) {
    return reportError(study.error());
  }
  if (options.perturbed) {
    const auto followed = [](const BoxPerturbationRow& row) {
      fmt::print(stderr, "{}: {}, first box of {:.1f} times the size\n", row.clip, row.method,
                 row.scale);
      return !wasInterruptionRequested();
    };
    auto rows =
        studyPerturbedBoxes(clips, options.seeds, followed, perturbationMethods(), options.first);
    if (!rows) {
      return reportError(rows.error());
    }
    study->perturbedRows = std::move(*rows);
  }
  fmt::print("{}", boxStudyText(*study));
  const auto written = writeBoxStudy(*study, options.folder);
  return written ? static_cast<int>(kExitDone) : reportError(written.error());
}

} // namespace

void addSugandiExperiment(CLI::App& group, int& exitCode) {
  auto* command = group.add_subcommand(
      "sugandi-rmse", "Methods sugandi and histogram against OpenCV's trackers: error, success, "
                      "precision, time.");
  auto options = std::make_shared<SugandiOptions>();
  command->add_option("--out", options->folder, "Folder to write")->required();
  command
      ->add_option(
          "--data", options->data,
          "Folder with the recordings juggle1 and otb; if omitted, only the rendered clip is used")
      ->envname("DEWPOINT_DATA");
  command->add_option("--scene", options->scene, "Seed of the rendered clip")
      ->capture_default_str();
  command->add_option("--seed", options->first, "The first seed of Dewpoint's methods")
      ->capture_default_str();
  command->add_option("--seeds", options->seeds, "Runs of each of Dewpoint's methods")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--sloppy", options->perturbed,
                    "Also start from boxes that are too large, too small, or shifted");
  command->callback([options, &exitCode] { exitCode = studySugandi(*options); });
}

} // namespace dewpoint::app
