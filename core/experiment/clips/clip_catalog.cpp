// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/clips/clip_catalog.h"

#include "core/experiment/clips/clip_sources.h"

#include <vector>

namespace dewpoint::experiment {
namespace {

constexpr const char* kOneClick =
    "one click in one camera, from which the color is learned, and a box of 0.1 m half size "
    "around the first position.";
constexpr const char* kTrueBox = "the true box of the first frame.";
constexpr double kHandMarkMm = 10.0;  // of hand2_desk, bench/clips/README.md
constexpr double kBoardMm = 2.0;      // of charuco4, the recording's notes
constexpr double kCentroidPx = 2.0;   // of tapes2_limbs and throws_pinkball, the recordings' notes
constexpr double kJuggleMarkPx = 3.0; // of juggle1, the recording's notes
constexpr double kOtbMarkPx = 5.0;    // of otb; assumed: the benchmark states none

ClipDeclaration handRow() {
  ClipDeclaration clip;
  clip.name = "R1-hand";
  clip.recording = "hand2_desk";
  clip.description =
      "A hand over a desk, two cameras, 352 frames: it points, opens, closes and turns; "
      "the forearm has its color.";
  clip.learningDescription = kOneClick;
  clip.truthDescription =
      "the center of the hand without fingers and forearm, 40 frames in both images "
      "(bench/clips); lengths are off by an unknown factor of up to 17 %, as the size of "
      "the calibration's chessboard is not known";
  clip.origin = TruthOrigin::Marked;
  clip.truthSigma = kHandMarkMm;
  clip.tuningUse = TuningUse::Viewed;
  clip.tuningNote =
      "color range and parameters of its example project were set by hand, which are not "
      "used here; the truth was made later than the methods";
  clip.needsTruthFolder = true;
  clip.calibrated = handClip;
  return clip;
}

ClipDeclaration boxedHandRow() {
  ClipDeclaration clip = handRow();
  clip.name = "R1-hand-boxed";
  clip.description += " One box around the hand says that it is the target, not the forearm.";
  clip.learningDescription =
      "one box around the hand in one camera, from which color and radius are learned, "
      "and a box of 0.1 m half size around the first position.";
  clip.tuningNote = "that a box marks a part was made and tried on it, with other boxes";
  clip.tuningUse = TuningUse::Yes;
  clip.calibrated = boxedHandClip;
  return clip;
}

ClipDeclaration bandsRow() {
  ClipDeclaration clip;
  clip.name = "R1-bands";
  clip.recording = "tapes2_limbs";
  clip.description = "Yellow, light-blue and pink bands on the knee, ankle and wrist of a man who "
                     "pedals on a chair and swings an arm, two webcams, 163 frames; measured in "
                     "pixels, as the length of the baseline is not known.";
  clip.learningDescription =
      "one click per band in the left camera, from which its color is learned, and a box "
      "around all three, with 0.3 m around them.";
  clip.truthDescription =
      "centroids of the bands' colors in both images of every frame; the shaded lower part "
      "of the yellow band is left out of it, which lifts its center by up to 5 px";
  clip.origin = TruthOrigin::Segmented;
  clip.truthSigma = kCentroidPx;
  clip.tuningUse = TuningUse::No;
  clip.tuningNote = "no document, test or benchmark uses it";
  clip.calibrated = bandsClip;
  return clip;
}

ClipDeclaration boardRow() {
  ClipDeclaration clip;
  clip.name = "R1-board";
  clip.recording = "charuco4";
  clip.description =
      "A man waves a board of black and white squares before four webcams, 57 "
      "instants, 6 per second, each camera with its own time stamps. Color methods are "
      "not made for this: the target is flat, and doors and sky are as white.";
  clip.learningDescription =
      "one click on a white square, from which the color is learned, and a box of 0.1 m "
      "half size around the first position.";
  clip.truthDescription =
      "the board's center, the mean of opposite corners of the published twelve";
  clip.origin = TruthOrigin::Board;
  clip.truthSigma = kBoardMm;
  clip.tuningUse = TuningUse::Viewed;
  clip.tuningNote =
      "the people methods' example project and the tests of calibration use it; nothing "
      "that tracks a target of a color was tried on it";
  clip.calibrated = boardClip;
  return clip;
}

/// A clip of one camera that recordedBoxClips() has under the name `clipName`.
ClipDeclaration imageRow(const char* name, const char* recording, const char* clipName,
                         const char* sentence) {
  ClipDeclaration clip;
  clip.name = name;
  clip.recording = recording;
  clip.description = sentence;
  clip.learningDescription = kTrueBox;
  clip.images = [clipName](const ClipFolders& folders) {
    return recordedBoxClip(folders, clipName);
  };
  clip.seedCount = 2; // as the box study; OpenCV's trackers have no randomness
  return clip;
}

ClipDeclaration juggleRow(const char* name, const char* clipName) {
  ClipDeclaration clip = imageRow(
      name, "juggle1", clipName,
      "One of three juggled balls, one camera, 99 frames, up to 70 px from frame to frame; "
      "hands and the other balls pass in front.");
  clip.truthDescription =
      "centers of every frame, marked by a person; a box of 28 px stands for the ball";
  clip.origin = TruthOrigin::Marked;
  clip.truthSigma = kJuggleMarkPx;
  clip.tuningUse = TuningUse::Yes;
  clip.tuningNote =
      "the defaults of histogram were chosen so that it keeps these balls, and the learning "
      "of colors and boxes from a click was measured on them while it was made";
  return clip;
}

ClipDeclaration throwRow(const char* name, const char* clipName) {
  ClipDeclaration clip =
      imageRow(name, "throws_pinkball", clipName,
               "A thrown ball in slow motion, one wide-angle camera, 75 to 101 frames, among gray "
               "and white balls.");
  clip.truthDescription = "boxes of every frame by background difference and hue";
  clip.origin = TruthOrigin::Segmented;
  clip.truthSigma = kCentroidPx;
  clip.tuningUse = TuningUse::Yes;
  clip.tuningNote =
      "histogram's search for the figure in a first box, and the learning of colors and "
      "boxes from a click, were measured on it while they were made";
  return clip;
}

ClipDeclaration otbRow(const char* name, const char* clipName, const char* sentence) {
  ClipDeclaration clip = imageRow(name, "otb", clipName, sentence);
  clip.truthDescription = "boxes of every frame, drawn by people, of the benchmark OTB-100";
  clip.origin = TruthOrigin::Marked;
  clip.truthSigma = kOtbMarkPx;
  clip.tuningUse = TuningUse::Yes;
  clip.tuningNote = "histogram was compared on it, box by box, while it was made";
  return clip;
}

} // namespace

std::span<const ClipDeclaration> clipCatalog() {
  static const std::vector<ClipDeclaration> kClips{
      handRow(),
      boxedHandRow(),
      bandsRow(),
      boardRow(),
      juggleRow("R2-juggle-red", "juggle1, red ball"),
      juggleRow("R2-juggle-blue", "juggle1, blue ball"),
      juggleRow("R2-juggle-yellow", "juggle1, yellow ball"),
      throwRow("R2-throw-pink", "throws_pinkball, pink ball"),
      throwRow("R2-throw-orange", "throws_pinkball, orange ball"),
      throwRow("R2-throw-blue", "throws_pinkball, blue ball"),
      throwRow("R2-throw-yellow", "throws_pinkball, yellow ball"),
      otbRow("R2-otb-crossing", "otb, Crossing",
             "A dark pedestrian in shadow, static camera, 120 frames of 360 x 240 pixels; a car "
             "passes."),
      otbRow("R2-otb-couple", "otb, Couple",
             "Two people who walk together, moving camera, 140 frames of 320 x 240 pixels."),
  };
  return kClips;
}

std::span<const OmittedRecording> omittedRecordings() {
  static const std::vector<OmittedRecording> kRecordings{
      {"ball9_arena",
       "It contains detections of a ball but no images, so no method that needs images can run."},
      {"opencv_left13",
       "It contains still images of a chessboard: ground truth for intrinsics, not for a target."},
      {"stereo_tray", "It contains 14 separate stereo images of a chessboard on a tray, not a "
                      "sequence: ground truth for a calibration."},
      {"ufes4_people", "It contains no ground truth for the people in it."},
  };
  return kRecordings;
}

} // namespace dewpoint::experiment
