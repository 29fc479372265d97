// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/doctor/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace dewpoint::setup {
namespace {

using enum FindingKind;
constexpr auto kFine = FindingLevel::Ok;
constexpr auto kNote = FindingLevel::Note;
constexpr auto kProblem = FindingLevel::Problem;

constexpr std::array kFindingTexts{
    FindingTexts{ProjectRead, "project-read", kFine, "The project can be read.", ""},
    FindingTexts{ProjectUnreadable, "project-unreadable", kProblem,
                 "The project cannot be read: %1.",
                 "Correct the project file in a text editor, or make a new project."},
    FindingTexts{FileMissing, "file-missing", kProblem, "A file of the project is missing: %1.",
                 "Put the missing file or folder back, or correct its path in the project file."},
    FindingTexts{MixedSources, "mixed-sources", kProblem,
                 "Some cameras are live and others are recordings.",
                 "Make one project of the live cameras and another one of the recordings."},
    FindingTexts{CannotOpen, "cannot-open", kProblem, "The project cannot be opened: %1.",
                 "Solve this problem, then check again."},
    FindingTexts{RecordingFine, "recording-fine", kFine, "%1 has %2 frames of %3 pixels, %4.", ""},
    FindingTexts{RecordingMissing, "recording-missing", kProblem,
                 "The recording of %1 is missing: %2.",
                 "Put the missing file or folder back, or correct its path in the project file."},
    FindingTexts{RecordingUnreadable, "recording-unreadable", kProblem,
                 "The recording of %1 cannot be opened: %2.",
                 "Copy the recording again, or convert it with FFmpeg."},
    FindingTexts{
        ImagesMissing, "images-missing", kNote,
        "Judging by the numbers in the file names, %2 of %3 images of %1 are missing, the "
        "first one after %4.",
        "Copy the image folder again; otherwise the camera has no image in the missing frames."},
    FindingTexts{FrameUnreadable, "frame-unreadable", kProblem,
                 "Frame %2 of %1 cannot be read: %3.",
                 "Copy the recording again, or use only the frames before the unreadable one."},
    FindingTexts{VideoCutOff, "video-cut-off", kProblem, "The video of %1 is cut off: %2.",
                 "Copy the video again, or repair it with FFmpeg (ffmpeg -i IN -c copy OUT)."},
    FindingTexts{
        SizeDiffers, "size-differs", kProblem,
        "The images of %1 have %2 pixels, but its calibration is for %3.",
        "Use a calibration for images of this size, or record images of the calibrated size."},
    FindingTexts{SizeRotated, "size-rotated", kProblem,
                 "The images of %1 have %2 pixels, but its calibration is for %3.",
                 "In the project file, set the key 'rotate' of this camera to 90 or 270."},
    FindingTexts{LengthsDiffer, "lengths-differ", kNote, "The recordings differ in length: %1.",
                 "Only the first %2 frames of each recording are used; check that all recordings "
                 "begin at the same time."},
    FindingTexts{DeviceFound, "device-there", kFine, "The device of %1 is connected.", ""},
    FindingTexts{DeviceMissing, "device-missing", kProblem,
                 "The device of %1 is not connected: %2.",
                 "Connect the device, or choose another one."},
    FindingTexts{StreamNotTested, "stream-not-tried", kNote,
                 "The stream of %1 was not tested: the check opens no network connections.",
                 "Open the project to see whether images arrive."},
    FindingTexts{BackgroundImageUnusable, "empty-room-unusable", kProblem,
                 "The background image of %1 cannot be used: %2.",
                 "Take the background image again, or remove this camera's key 'empty_room' from "
                 "the project file."},
    FindingTexts{SceneCameras, "scene-cameras", kFine, "Simulated cameras: %1.", ""},
    FindingTexts{
        RatesDiffer, "rates-differ", kProblem, "The recordings have different frame rates: %1.",
        "Convert the recordings to the same frame rate, or give each camera a table of times."},
    FindingTexts{RateOverridden, "rate-overridden", kNote,
                 "The project says %1 frames per second, but the video of %2 has %3.",
                 "Remove frames_per_second from the project file, unless the rate stated in the "
                 "video is wrong."},
    FindingTexts{RateAssumed, "rate-assumed", kNote,
                 "The frame rate of the images is not given; %1 frames per second are assumed.",
                 "Set frames_per_second in the project file; the measured speeds depend on it."},
    FindingTexts{
        TimesUnusable, "times-unusable", kProblem, "The table of times of %1 cannot be used: %2.",
        "Correct the table of times, or remove this camera's key 'times' from the project file."},
    FindingTexts{TimesCountDiffers, "times-count-differs", kProblem,
                 "The table of times of %1 has %2 times, but there are %3 images.",
                 "Use the table of times that belongs to this recording."},
    FindingTexts{TimesIncomplete, "times-incomplete", kProblem,
                 "Other cameras have a table of times, but %1 has none.",
                 "Give a table of times to every camera, or to none."},
    FindingTexts{TimesApart, "times-apart", kProblem,
                 "According to their tables of times, the cameras never recorded at the same time.",
                 "Check that the time stamps of all cameras (in their tables of times) are from "
                 "the same clock."},
    FindingTexts{
        DelayTooLong, "delay-too-long", kProblem,
        "The delay of %1 (%2 s) is longer than its recording, so this camera has no image "
        "in any frame.",
        "In the project file, correct the value of late_by for this camera. It is in seconds."},
    FindingTexts{
        DelayUnusual, "delay-unusual", kNote, "The delay of %1 is %2 s, which is unusually large.",
        "In the project file, check the value of late_by for this camera. It is in seconds."},
    FindingTexts{CalibrationFine, "calibration-fine", kFine,
                 "The calibration is plausible (cameras: %1, largest distance between them: %2 m).",
                 ""},
    FindingTexts{CalibrationGuessed, "calibration-guessed", kProblem,
                 "The cameras are not calibrated: their poses are guesses, so tracked positions "
                 "mean nothing.",
                 "Calibrate the cameras with a board, a wand or measured points."},
    FindingTexts{UnitWrong, "unit-wrong", kProblem,
                 "The cameras are %1 m apart: their positions are probably in units of %2 m.",
                 "Import the calibration again with the right unit (calibration convert --unit)."},
    FindingTexts{CalibrationImplausible, "calibration-implausible", kProblem,
                 "The calibration cannot be right: %1.",
                 "Import the calibration again, or calibrate the cameras again."},
    FindingTexts{
        SamePose, "same-pose", kProblem, "%1 and %2 have the same pose.",
        "Calibrate both cameras again; the pose of one was probably copied from the other."},
    FindingTexts{
        BelowFloor, "under-floor", kNote, "%1 is %2 m below the floor (z = 0).",
        "Check that z points up and is 0 on the floor, unless you placed the origin elsewhere."},
    FindingTexts{FacesAway, "looks-away", kNote,
                 "The view of %1 does not overlap with the view of any other camera.",
                 "Turn this camera toward the target, or calibrate it again."},
    FindingTexts{CamerasDisagree, "cameras-disagree", kProblem,
                 "In the first %1 s, the images do not fit the calibration: %2.", ""},
    FindingTexts{TargetsMissing, "targets-lacking", kProblem, "Nothing can be tracked: %1.",
                 "Add a target, or choose a method that finds targets by itself."},
    FindingTexts{ColorNotLearned, "color-not-learned", kProblem, "Target %1 has no color yet.",
                 "Click the target in an image, or use the command learn-color."},
    FindingTexts{ColorMatchesNothing, "color-matches-nothing", kProblem,
                 "No pixel can have the color of target %1: the color range is too narrow.",
                 "Learn the color again."},
    FindingTexts{ColorEverywhere, "color-everywhere", kProblem,
                 "In the images of %3, %2 % of all pixels have the color of target %1.",
                 "Learn the color again, with samples that do not reach beyond the target."},
    FindingTexts{ColorNowhere, "color-nowhere", kProblem,
                 "The color of target %1 was not found in any of the %2 checked images.",
                 "Learn the color again in an image of this recording."},
    FindingTexts{
        ColorNotInCamera, "color-not-in-camera", kNote,
        "The color of target %1 was not found in any of the checked images of %2.",
        "Check that the camera sees the target, and check its exposure and white balance."},
    FindingTexts{ColorFine, "color-fine", kFine,
                 "In the images, %2 % of all pixels have the color of target %1.", ""},
    FindingTexts{
        TargetOverexposed, "target-overexposed", kNote,
        "When the color of target %1 was learned, %2 % of its pixels in %3 were overexposed.",
        "Lower the exposure of the camera, and learn the color again in new images."},
    FindingTexts{TargetTooDark, "target-too-dark", kNote,
                 "When the color of target %1 was learned, %2 % of its pixels in %3 were too dark.",
                 "Raise the exposure of the camera or add light, and learn the color again in new "
                 "images."},
    FindingTexts{RadiusUnlikely, "radius-unlikely", kProblem,
                 "Target %1 has a radius of %2 m, which is larger than a person.",
                 "Give the radius in meters."},
    FindingTexts{BoxMissing, "box-missing", kProblem, "Target %1 has no box to start from.",
                 "Draw a box around the target in an image."},
    FindingTexts{BoxTooLate, "box-too-late", kProblem,
                 "The box of target %1 is in frame %2, but the last frame is frame %3.",
                 "Draw the box in an earlier frame."},
    FindingTexts{CorrectionTooLate, "correction-too-late", kNote,
                 "The project has corrections for frames that the recording does not have: %1.",
                 "Check that the corrections were made for this recording."},
    FindingTexts{MethodFits, "method-fits", kFine, "The method %1 can work with this project.", ""},
    FindingTexts{NeedsCalibration, "needs-calibration", kProblem,
                 "The method %1 needs calibrated cameras.",
                 "Calibrate the cameras, or choose a method that tracks boxes in images."},
    FindingTexts{NeedsMoreCameras, "needs-more-cameras", kProblem,
                 "The method %1 needs at least %2 cameras; this project has %3.",
                 "Add cameras, or choose another method."},
    FindingTexts{
        VolumeOutOfView, "volume-out-of-view", kProblem,
        "No part of the volume of interest is seen by enough cameras (at least %1 are needed).",
        "Move the volume of interest, or remove it."},
    FindingTexts{
        TruthUnusable, "truth-unusable", kProblem, "The true positions cannot be read: %1.",
        "Correct the file of true positions, or remove the key 'truth' from the project file."},
    FindingTexts{DiskFine, "disk-fine", kFine,
                 "There is enough disk space for results: %1 GB are free.", ""},
    FindingTexts{DiskNearlyFull, "disk-nearly-full", kNote, "Only %1 GB are free for results.",
                 "Free some disk space, or write to another disk with the option --out."},
    FindingTexts{DiskFull, "disk-full", kProblem, "Only %1 MB are free for results.",
                 "Free some disk space, or write to another disk with the option --out."},
    FindingTexts{FolderUnwritable, "folder-unwritable", kNote,
                 "Nothing can be written to the folder of the project.",
                 "Write the results to another folder with the option --out."},
};

} // namespace

std::span<const FindingTexts> findingTexts() {
  return kFindingTexts;
}

const FindingTexts& textsOf(FindingKind kind) {
  return *std::ranges::find(kFindingTexts, kind, &FindingTexts::kind);
}

FindingLevel worstLevelOf(const std::vector<Finding>& findings) {
  return worstLevel(findings, &Finding::level);
}

std::string fillPlaceholders(std::string_view words, const std::vector<std::string>& values) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const bool isPlace = words[k] == '%' && k + 1 < words.size() && words[k + 1] >= '1' &&
                         static_cast<std::size_t>(words[k + 1] - '1') < values.size();
    if (isPlace) {
      text += values[static_cast<std::size_t>(words[++k] - '1')];
    } else {
      text += words[k];
    }
  }
  if (!text.empty()) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  }
  return text;
}

std::string findingLine(const Finding& finding) {
  const FindingTexts& words = textsOf(finding.kind);
  std::string line = fmt::format("{:<8} {}", levelName(words.level),
                                 fillPlaceholders(words.description, finding.placeholderValues));
  if (!finding.file.empty() || !finding.field.empty()) {
    const bool both = !finding.file.empty() && !finding.field.empty();
    line += fmt::format(" ({}{}{})", finding.file, both ? ": " : "", finding.field);
  }
  if (!words.advice.empty()) {
    line += " " + fillPlaceholders(words.advice, finding.placeholderValues);
  }
  return line;
}

} // namespace dewpoint::setup
