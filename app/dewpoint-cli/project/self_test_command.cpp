// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/wiring/open_project.h"
#include "core/session/selftest/self_test.h"
#include "core/setup/new_project/footage.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <unistd.h>

namespace dewpoint::app {
namespace {

SelfTestInputs partsOfThisComputer() {
  SelfTestInputs parts;
  parts.openScene = [] { return openProject(SessionRequest("demo")); };
  parts.cameraNames = connectedCameras();
  std::error_code problem;
  parts.scratchFolder = std::filesystem::temp_directory_path(problem) /
                        fmt::format("dewpoint-self-test-{}", ::getpid());
  parts.shouldContinue = [] { return !wasInterruptionRequested(); };
  return parts;
}

int testAndPrint(bool asJson) {
  catchInterruption();
  const std::vector<SelfTestLine> lines = runSelfTest(partsOfThisComputer());
  if (wasInterruptionRequested()) {
    return kExitInterrupted;
  }
  auto list = nlohmann::ordered_json::array();
  for (const SelfTestLine& line : lines) {
    if (asJson) {
      list.push_back(
          {{"level", levelName(line.level)}, {"subject", line.subject}, {"text", line.text}});
    } else {
      fmt::print("{}\n", selfTestText(line));
    }
  }
  const FindingLevel worst = worstLevelOf(lines);
  if (asJson) {
    const nlohmann::ordered_json root{{"level", levelName(worst)}, {"lines", list}};
    fmt::print("{}\n", root.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  }
  return worst == FindingLevel::Problem ? kExitProblems : kExitDone;
}

} // namespace

void addSelfTestCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "self-test",
      "Check what tracking needs from this computer: codecs, disk, cameras, a short run.");
  auto asJson = std::make_shared<bool>(false);
  command->add_flag("--json", *asJson, "Print JSON instead of lines");
  command->footer("Exit codes: 0 no problem, 1 at least one problem.");
  command->callback([asJson, &exitCode] { exitCode = testAndPrint(*asJson); });
}

} // namespace dewpoint::app
