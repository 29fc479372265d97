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

/// One line of a self-test: what was tried, and how it went. In English, for those who read
/// reports; not translated.
struct SelfTestLine {
  FindingLevel level = FindingLevel::Ok;
  std::string subject; ///< "codec FFV1"
  std::string text;
};

/// What the self-test of this computer uses.
struct SelfTestParts {
  /// A simulated scene whose truth is known, which is tracked for kSelfTestSeconds of it; empty:
  /// that is left out.
  std::function<Result<SessionInputs>()> openScene = {};
  std::vector<std::string> cameras = {}; ///< devices of this computer
  /// A folder for files that are written and read back; made, and removed with all that is in it.
  std::filesystem::path scratch = {};
  /// Called between the parts; false ends the test.
  std::function<bool()> goOn = [] { return true; };
};

/// Of the scene that is tracked.
inline constexpr double kSelfTestSeconds = 5.0;

/// Tries what tracking needs of this computer: versions, processor and memory, disk, cameras,
/// codecs, and a run over a scene with known truth, with its rate and error. Takes some seconds.
std::vector<SelfTestLine> runSelfTest(const SelfTestParts& parts);

/// "ok       codec FFV1: ..."
std::string selfTestText(const SelfTestLine& line);

/// The worst level; Ok of none.
FindingLevel worstOf(const std::vector<SelfTestLine>& lines);

} // namespace dewpoint::session
