// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding_level.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::setup {

/// What a check of a project can find.
enum class FindingKind {
  // The file.
  ProjectRead,
  ProjectUnreadable,
  FileMissing,
  MixedSources,
  CannotOpen,
  // Recordings.
  RecordingFine,
  RecordingMissing,
  RecordingUnreadable,
  ImagesMissing,
  FrameUnreadable,
  VideoCutOff,
  SizeDiffers,
  SizeRotated,
  LengthsDiffer,
  DeviceThere,
  DeviceMissing,
  StreamNotTried,
  EmptyRoomUnusable,
  SceneCameras,
  // Times.
  RatesDiffer,
  RateOverridden,
  RateAssumed,
  TimesUnusable,
  TimesCountDiffers,
  TimesIncomplete,
  TimesApart,
  DelayTooLong,
  DelayUnusual,
  // Calibration.
  CalibrationFine,
  CalibrationGuessed,
  UnitWrong,
  CalibrationImplausible,
  SamePose,
  UnderFloor,
  LooksAway,
  CamerasDisagree,
  // Targets.
  TargetsLacking,
  ColorNotLearned,
  ColorMatchesNothing,
  ColorEverywhere,
  ColorNowhere,
  ColorNotInCamera,
  ColorFine,
  RadiusUnlikely,
  BoxMissing,
  BoxTooLate,
  CorrectionTooLate,
  // Method and volume.
  MethodFits,
  NeedsCalibration,
  NeedsMoreCameras,
  VolumeOutOfView,
  TruthUnusable,
  // Disk.
  DiskFine,
  DiskNearlyFull,
  DiskFull,
  FolderUnwritable,
};

/// The words of a kind of findings: a row of the table of all of them. Whole sentences, in which
/// "%1", "%2" ... stand for values.
struct FindingWords {
  FindingKind kind;
  std::string_view name; ///< for programs: "recording-missing"
  FindingLevel level;
  std::string_view what;
  std::string_view advice; ///< what to do; empty where nothing is to be done
};

/// All of them, in the order of the kinds.
std::span<const FindingWords> findingWords();
const FindingWords& wordsOf(FindingKind kind);

/// What a check of a project found, and where.
struct Finding {
  FindingKind kind = FindingKind::ProjectRead;
  std::vector<std::string> values = {}; ///< of the places in its words
  std::string file = {};                ///< empty where it is in none
  std::string field = {};               ///< as the project file calls it; may be empty

  FindingLevel level() const { return wordsOf(kind).level; }
};

/// The worst level of findings; Ok of none.
FindingLevel worstOf(const std::vector<Finding>& findings);

/// A text of the table with its values, and a capital at its beginning.
std::string filledIn(std::string_view words, const std::vector<std::string>& values);

/// One line in plain English: level, what, where in brackets, what to do.
std::string findingLine(const Finding& finding);

} // namespace dewpoint::setup
