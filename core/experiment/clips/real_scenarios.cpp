// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/clips/real_scenarios.h"

#include "core/base/units.h"

#include <fmt/format.h>

#include <utility>

namespace dewpoint::experiment {
namespace {

/// Whether truth is known in images only.
bool isInPixels(const ClipDeclaration& clip) {
  return clip.origin == TruthOrigin::Segmented || clip.images;
}

const char* originText(TruthOrigin origin) {
  switch (origin) {
  case TruthOrigin::Board:
    return "from a printed board, independent of every method";
  case TruthOrigin::Marked:
    return "marked by hand, independent of every method";
  case TruthOrigin::Segmented:
    break;
  }
  return "from the targets' colors, not independent";
}

const char* tunedText(TuningUse tuned) {
  switch (tuned) {
  case TuningUse::No:
    return "no";
  case TuningUse::Viewed:
    return "looked at";
  case TuningUse::Yes:
    break;
  }
  return "yes";
}

/// Why a clip is skipped; empty when its files are there.
std::string reasonToSkip(const ClipDeclaration& clip, const ClipFolders& folders) {
  if (folders.recordings.empty()) {
    return "no folder of recordings is given";
  }
  const auto folder = folders.recordings / clip.recording;
  if (!std::filesystem::is_directory(folder)) {
    return fmt::format("there is no folder {}", folder.string());
  }
  if (clip.needsTruthFolder && !std::filesystem::is_directory(folders.truth)) {
    return fmt::format(
        "its ground truth is missing: the folder bench/clips of the source code ('{}')",
        folders.truth.string());
  }
  return {};
}

ScenarioDeclaration scenarioOf(const ClipDeclaration& clip, const ClipFolders& folders) {
  ScenarioDeclaration scenario;
  scenario.name = clip.name;
  scenario.family = clip.name.substr(0, clip.name.find('-'));
  scenario.description = clipDescription(clip);
  scenario.seedCount = clip.seedCount;
  scenario.isRecorded = true;
  if (clip.images) {
    scenario.clip = [images = clip.images, folders] { return images(folders); };
  } else {
    const double sigma = isInPixels(clip) ? 0.0 : fromMillimeters(clip.truthSigma);
    scenario.make = [calibrated = clip.calibrated, folders, sigma](std::uint64_t seed,
                                                                   Grade) -> Result<ScenarioRun> {
      const auto source = calibrated(folders);
      if (!source) {
        return tl::make_unexpected(source.error());
      }
      return makeClipRun(*source, seed).map([&](ScenarioRun run) {
        run.truthSigma = sigma;
        return run;
      });
    };
  }
  return scenario;
}

} // namespace

RealScenarios makeRealScenarios(const ClipFolders& folders,
                                std::span<const ClipDeclaration> catalog) {
  RealScenarios result;
  for (const ClipDeclaration& clip : catalog) {
    if (const std::string reason = reasonToSkip(clip, folders); reason.empty()) {
      result.scenarios.push_back(scenarioOf(clip, folders));
    } else {
      result.skippedClips.push_back(
          {clip.name, fmt::format("{} is skipped: {}.", clip.name, reason)});
    }
  }
  return result;
}

std::string clipDescription(const ClipDeclaration& clip) {
  return fmt::format("{} Start: {} Truth: {} ({}; ±{:g} {}). Tuned on: {} ({}).", clip.description,
                     clip.learningDescription, clip.truthDescription, originText(clip.origin),
                     clip.truthSigma, isInPixels(clip) ? "px" : "mm", tunedText(clip.tuningUse),
                     clip.tuningNote);
}

} // namespace dewpoint::experiment
