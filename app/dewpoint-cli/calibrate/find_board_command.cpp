// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/calibrate/calibrate_commands.h"
#include "app/dewpoint-cli/calibrate/calibrate_output.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/wiring/open_project.h"
#include "core/setup/calibration/board_recording.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace dewpoint::app {
namespace {

struct FindBoardOptions {
  std::vector<std::string> inputs;
  double square = 0.0; ///< side of a square, meters; 0: not known
  int looks = kBoardProposalFrames;
};

/// The boards, and one sentence about mirrored videos or none.
struct FoundGuesses {
  std::vector<BoardGuess> guesses;
  std::string mirrored;
};

/// The boards in a project's recording, and which of its videos are mirrored.
Result<FoundGuesses> guessesIn(const SessionInputs& inputs, const BoardDescription& lengths,
                               int looks, const CalibrationProgress& progress) {
  std::vector<std::string> names;
  for (const ProjectCamera& camera : inputs.project.cameras) {
    names.push_back(camera.camera.name);
  }
  return proposeBoardsAndMirroredVideos(*inputs.source, lengths, looks, progress)
      .and_then([&](BoardRecordingProposal proposal) {
        return proposal.mirroredVideos.map([&](const MirroredVideos& mirrored) {
          return FoundGuesses{std::move(proposal.guesses), mirroredText(mirrored, names)};
        });
      });
}

Result<FoundGuesses> proposedBoards(const FindBoardOptions& options) {
  BoardDescription lengths;
  lengths.squareSize = options.square > 0.0 ? options.square : lengths.squareSize;
  const auto progress = interruptibleProgress();
  if (!isSingleProject(options.inputs)) {
    return proposeBoards({options.inputs.begin(), options.inputs.end()}, lengths, options.looks,
                         progress)
        .map([](std::vector<BoardGuess> guesses) {
          return FoundGuesses{std::move(guesses), {}};
        });
  }
  return resolveProject(options.inputs.front())
      .and_then(openInputs)
      .and_then([&](const SessionInputs& inputs) {
        return guessesIn(inputs, lengths, options.looks, progress);
      });
}

int findBoard(const FindBoardOptions& options) {
  const auto found = proposedBoards(options);
  if (!found) {
    return reportCalibrationError(found.error());
  }
  for (const BoardGuess& guess : found->guesses) {
    fmt::print("{}\n  {}: {} corners in {} of {} images\n", boardText(guess.board),
               describeGuess(guess), guess.cornerCount, guess.imageCount, guess.searchedImageCount);
    if (guess.isMirrored) {
      fmt::print("  The images are mirrored left to right: set mirror = true in the project file, "
                 "or false if it is set.\n");
    }
  }
  if (!found->mirrored.empty()) {
    fmt::print("note: {}\n", found->mirrored);
  }
  if (options.square <= 0.0) {
    fmt::print("Images do not show lengths. Replace {} by the measured side of a square in "
               "meters, or use --square.\n",
               found->guesses.front().board.squareSize);
  }
  return kExitDone;
}

} // namespace

void addFindBoardCommand(CLI::App& group, int& exitCode) {
  auto* command = group.add_subcommand(
      "find-board",
      "Find out from images which board they show: its kind, squares and dictionary.");
  auto options = std::make_shared<FindBoardOptions>();
  command
      ->add_option("INPUT", options->inputs,
                   "Project file (TOML), whose recordings are used, or image files")
      ->required();
  command
      ->add_option(
          "--square", options->square,
          "Side of a square that you measured, meters; it is inserted in the printed values")
      ->check(CLI::Range(1e-4, 10.0));
  command
      ->add_option("--looks", options->looks,
                   "Number of frames of the recording, or number of image files, to search")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->callback([options, &exitCode] { exitCode = findBoard(*options); });
}

} // namespace dewpoint::app
