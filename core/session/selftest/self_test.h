// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/finding_level.h"
#include "core/session/session_inputs.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::session {

/// One line of a self-test: the subject of the test and its result, as English text.
struct SelfTestLine {
  FindingLevel level = FindingLevel::Ok;
  std::string subject; ///< for example "codec FFV1"
  std::string text;
};

/// Inputs of the self-test, which tests whether this computer is suitable for tracking.
struct SelfTestInputs {
  /// Opens a simulated scene with known ground truth. The self-test tracks its first
  /// kSelfTestSeconds. If empty, this test is omitted.
  std::function<Result<SessionInputs>()> openScene = {};
  std::vector<std::string> cameraNames = {}; ///< camera devices of this computer
  /// Folder for test files. The self-test creates the folder and removes it afterward with all its
  /// contents.
  std::filesystem::path scratchFolder = {};
  /// Called between the tests. If it returns false, the self-test ends.
  std::function<bool()> shouldContinue = [] { return true; };
};

/// Duration, in seconds, of the part of the simulated scene that the self-test tracks.
inline constexpr double kSelfTestSeconds = 5.0;

/// Tests whether this computer is suitable for tracking: versions, processor and memory, disk,
/// cameras, codecs, and the frame rate and error of a run on a scene with known ground truth. Takes
/// several seconds.
std::vector<SelfTestLine> runSelfTest(const SelfTestInputs& parts);

/// Returns a line of the self-test as text, for example "ok       codec FFV1: ..."
std::string selfTestText(const SelfTestLine& line);

/// Returns the worst level (result) of all lines of a self-test; Ok if there are no lines.
FindingLevel worstLevelOf(const std::vector<SelfTestLine>& lines);

} // namespace dewpoint::session
