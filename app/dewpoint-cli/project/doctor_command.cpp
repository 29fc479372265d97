// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/progress.h"
#include "app/wiring/open_project.h"
#include "core/setup/doctor/doctor.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace dewpoint::app {
namespace {

struct DoctorOptions {
  std::string project;
  std::string out;
  bool decodesEveryFrame = false;
  bool asJson = false;
};

Result<std::unique_ptr<FrameSetSource>> openAsARunDoes(const Project& project) {
  auto inputs = openProject(SessionRequest(project));
  if (!inputs) {
    return tl::make_unexpected(inputs.error());
  }
  return std::move(inputs->source);
}

std::vector<Finding> findingsOf(const DoctorOptions& options) {
  auto project = resolveProject(options.project);
  if (!project) {
    return examineUnreadableProject(options.project, project.error());
  }
  constexpr int kParts = 100;
  Progress progress("checking", kParts);
  ExaminationOptions examination;
  examination.outputFolder = options.out;
  examination.decodesEveryFrame = options.decodesEveryFrame;
  examination.open = &openAsARunDoes;
  examination.shouldContinue = [&](double part) {
    progress.show(static_cast<std::int64_t>(kParts * part));
    return !wasInterruptionRequested();
  };
  auto findings = examine(*project, examination);
  progress.finish();
  return findings;
}

void printJson(const std::vector<Finding>& findings) {
  auto list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) {
    const FindingTexts& words = textsOf(finding.kind);
    list.push_back({{"level", levelName(words.level)},
                    {"check", std::string(words.name)},
                    {"what", fillPlaceholders(words.description, finding.placeholderValues)},
                    {"file", finding.file},
                    {"field", finding.field},
                    {"advice", fillPlaceholders(words.advice, finding.placeholderValues)}});
  }
  const nlohmann::ordered_json root{{"level", levelName(worstLevelOf(findings))},
                                    {"findings", list}};
  fmt::print("{}\n", root.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

int examineAndPrint(const DoctorOptions& options) {
  catchInterruption();
  const std::vector<Finding> findings = findingsOf(options);
  if (wasInterruptionRequested()) {
    return kExitInterrupted;
  }
  if (options.asJson) {
    printJson(findings);
  } else {
    for (const Finding& finding : findings) {
      fmt::print("{}\n", findingLine(finding));
    }
  }
  return worstLevelOf(findings) == FindingLevel::Problem ? kExitProblems : kExitDone;
}

} // namespace

void addDoctorCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "doctor", "Check a project for problems: recordings, times, calibration, colors, method.");
  auto options = std::make_shared<DoctorOptions>();
  command->add_option("PROJECT", options->project, "Project file, or the name of a built-in scene")
      ->required();
  command->add_option("--out", options->out,
                      "Folder for the results; the folder of the project if omitted");
  command->add_flag("--every-frame", options->decodesEveryFrame,
                    "Read all frames, instead of only the first, middle and last frame");
  command->add_flag("--json", options->asJson, "Print JSON instead of lines");
  command->footer("Exit codes: 0 no problem, 1 at least one problem.");
  command->callback([options, &exitCode] { exitCode = examineAndPrint(*options); });
}

} // namespace dewpoint::app
