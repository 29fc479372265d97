// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/clips/clip_declaration.h"
#include "core/experiment/scenarios/scenario.h"

#include <span>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Clip that is left out because its files are missing.
struct SkippedClip {
  std::string name;        ///< name of the clip
  std::string description; ///< message that names the clip and the missing files
};

/// Real clips (recordings with ground truth) as scenarios of the accuracy suite.
struct RealScenarios {
  std::vector<ScenarioDeclaration> scenarios;
  std::vector<SkippedClip> skippedClips;
};

/// Creates scenarios from those clips of a catalog (clipCatalog()) whose recordings are in the
/// folders. A clip whose recording exists but is broken is not skipped; its run reports an error.
RealScenarios makeRealScenarios(const ClipFolders& folders,
                                std::span<const ClipDeclaration> catalog);

/// Returns the description of a clip for a report: what it shows, how a target is learned, the
/// truth, and whether methods were tuned on it.
std::string clipDescription(const ClipDeclaration& clip);

} // namespace dewpoint::experiment
