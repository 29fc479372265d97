// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding_level.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::setup {

/// Possible findings of the checks of a project.
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
  DeviceFound,
  DeviceMissing,
  StreamNotTested,
  BackgroundImageUnusable,
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
  BelowFloor,
  FacesAway,
  CamerasDisagree,
  // Targets.
  TargetsMissing,
  ColorNotLearned,
  ColorMatchesNothing,
  ColorEverywhere,
  ColorNowhere,
  ColorNotInCamera,
  ColorFine,
  TargetOverexposed,
  TargetTooDark,
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

/// Texts of a kind of finding: one row of the table findingTexts(). They are full sentences in
/// which "%1", "%2" ... are placeholders for values.
struct FindingTexts {
  FindingKind kind;
  std::string_view name; ///< identifier for programs, for example "recording-missing"
  FindingLevel level;
  std::string_view description; ///< what was found
  std::string_view advice;      ///< recommended action; empty if there is nothing to do
};

/// Returns the texts of all kinds of findings, in the order of FindingKind.
std::span<const FindingTexts> findingTexts();
/// Returns the texts of a kind of finding.
const FindingTexts& textsOf(FindingKind kind);

/// A finding of a check, and the file and field it refers to.
struct Finding {
  FindingKind kind = FindingKind::ProjectRead;
  std::vector<std::string> placeholderValues = {}; ///< values for the placeholders in the texts
  std::string file = {};  ///< file to which the finding refers; empty if it refers to no file
  std::string field = {}; ///< name of the field in the project file; may be empty

  FindingLevel level() const { return textsOf(kind).level; }
};

/// Returns the worst level of findings; Ok if there are none.
FindingLevel worstLevelOf(const std::vector<Finding>& findings);

/// Returns a text of findingTexts() (`words`) with `values` in place of the placeholders. The
/// result begins with a capital letter.
std::string fillPlaceholders(std::string_view words, const std::vector<std::string>& values);

/// Returns one line in English: the level, the finding, its file and field (in brackets), and the
/// recommended action.
std::string findingLine(const Finding& finding);

} // namespace dewpoint::setup
