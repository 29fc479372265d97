// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/clips/clip_declaration.h"
#include "core/experiment/scenarios/scenario.h"

#include <span>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// A clip that is left out because its files are not there.
struct SkippedClip {
  std::string name;     ///< of the clip
  std::string sentence; ///< with the name, and what is missing
};

/// The real clips as scenarios of the suite.
struct RealScenarios {
  std::vector<ScenarioDeclaration> scenarios;
  std::vector<SkippedClip> skipped;
};

/// The clips of a catalog (clipCatalog()) whose recordings are in the folders. A recording that is
/// there but broken is not skipped: its run is an error.
RealScenarios realScenarios(const ClipFolders& folders, std::span<const ClipDeclaration> catalog);

/// What a report says of a clip: what is to be seen, how a target is learned, the truth, and
/// whether methods were tuned on it.
std::string clipSentence(const ClipDeclaration& clip);

} // namespace dewpoint::experiment
