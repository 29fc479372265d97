// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/board/board_text.h"

#include "ui/calibration/board/board_calibrator.h"
#include "ui/text/calibration_text.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace dewpoint::ui {
namespace {

class BoardText {
  Q_DECLARE_TR_FUNCTIONS(BoardText)
};

constexpr double kPoorlyKnownPx = 5.0; ///< somewhere in the image: worth a warning

QString lensLine(const QString& name, const IntrinsicsResult& lens) {
  const auto used = std::ranges::count(lens.views, true, &ViewFit::isUsed);
  QString line = BoardText::tr("%1: RMS reprojection error %2, focal length %3, accuracy of the "
                               "intrinsics %5, from %4 images")
                     .arg(name, pixelText(lens.rmsPx, 3), pixelText(lens.camera.intrinsics.focalX),
                          QString::number(used), pixelText(lens.maxProjectionSigmaPx, 2));
  if (lens.maxProjectionSigmaPx > kPoorlyKnownPx) {
    line += QStringLiteral("\n⚠ ") +
            BoardText::tr("The board's corners cover only %1 % of the image: show the board in "
                          "every part of the image, and tilt it too.")
                .arg(percentNumber(lens.coverage.coveredFraction()));
  }
  return line;
}

/// Why an image shows no board, in parentheses behind its name or number.
QString missReason(const QString& image, const BoardMiss& miss) {
  switch (miss.reason) {
  case BoardMiss::Reason::TooFewCorners:
    return BoardText::tr("%1 (too few corners: %2)").arg(image, QString::number(miss.cornerCount));
  case BoardMiss::Reason::Blurred:
    return BoardText::tr("%1 (blurred: edges are %2 wide)")
        .arg(image, pixelText(miss.edgeWidthPx, 0));
  case BoardMiss::Reason::TooSmall:
    return BoardText::tr("%1 (too small: squares are only %2 wide)")
        .arg(image, pixelText(miss.squareSizePx, 0));
  case BoardMiss::Reason::Unknown:
    break;
  }
  return image;
}

/// The frames without the board, counted from 1 as in the timeline.
QString missedLine(const QString& name, const std::vector<MissedRun>& runs) {
  QStringList listed;
  int others = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const MissedRun& run = runs[k];
    if (k >= kMaxListedRuns) {
      others += run.imageCount;
      continue;
    }
    const QString first = frameNumberText(run.firstNumber);
    listed << missReason(run.firstNumber == run.lastNumber
                             ? first
                             : QStringLiteral("%1–%2").arg(first, frameNumberText(run.lastNumber)),
                         run.missReason);
  }
  const QString frames = listed.join(QStringLiteral(", "));
  return others == 0 ? BoardText::tr("%1: no board was found in frames %2.").arg(name, frames)
                     : BoardText::tr("%1: no board was found in frames %2 and in %3 others.")
                           .arg(name, frames, QString::number(others));
}

QString placeLine(const QString& name, const CameraFit& fit) {
  if (fit.views.empty()) {
    return BoardText::tr("%1 keeps its position because it never saw the board.").arg(name);
  }
  if (fit.centerSigma > 0.0) {
    return BoardText::tr("%1: RMS reprojection error %2, position ±%3, direction ±%4")
        .arg(name, pixelText(fit.rmsPx, 3),
             lengthText(fit.centerSigma, LengthScale::Millimeters, 2),
             angleText(fit.rotationSigma, 3));
  }
  return BoardText::tr("%1: RMS reprojection error %2").arg(name, pixelText(fit.rmsPx, 3));
}

void addLenses(const BoardCalibrator& calibrator, const BoardOutcome& outcome, QStringList& lines) {
  const LensesFromBoards& lenses = *outcome.lenses;
  lines << BoardText::tr("Intrinsics");
  std::size_t kept = 0;
  for (std::size_t k = 0; k < lenses.cameras.size(); ++k) {
    if (lenses.cameras[k]) {
      lines << lensLine(calibrator.nameOf(k), *lenses.cameras[k]);
      if (k < outcome.missedRuns.size() && !outcome.missedRuns[k].empty()) {
        lines << missedLine(calibrator.nameOf(k), outcome.missedRuns[k]);
      }
    } else {
      lines << QStringLiteral("⚠ ") +
                   BoardText::tr("The intrinsics of %1 are unchanged: %2")
                       .arg(calibrator.nameOf(k),
                            QString::fromStdString(lenses.keptIntrinsicsReasons.at(kept++).detail));
    }
  }
}

void addPlaces(const BoardCalibrator& calibrator, const ExtrinsicsResult& places,
               QStringList& lines) {
  if (!lines.isEmpty()) {
    lines << QString();
  }
  lines << BoardText::tr("Camera positions: RMS reprojection error %1, from %2 board poses")
               .arg(pixelText(places.rmsPx, 3), QString::number(places.boardPoses.size()));
  for (std::size_t k = 0; k < places.cameraFits.size(); ++k) {
    lines << placeLine(calibrator.nameOf(k), places.cameraFits[k]);
  }
  // The last ones are about cameras that never saw the board: said already.
  const auto blind = std::ranges::count_if(places.cameraFits,
                                           [](const CameraFit& fit) { return fit.views.empty(); });
  for (std::size_t k = 0; k + static_cast<std::size_t>(blind) < places.notices.size(); ++k) {
    lines << QStringLiteral("⚠ ") + QString::fromStdString(places.notices[k]) + QLatin1Char('.');
  }
}

} // namespace

QString regionText(int region) {
  const int column = region % BoardCoverage::kColumns / 2;    // left, middle, right
  const int row = (region / BoardCoverage::kColumns + 1) / 2; // top, middle, bottom
  const QString names[3][3] = {
      {BoardText::tr("upper left"), BoardText::tr("top"), BoardText::tr("upper right")},
      {BoardText::tr("left"), BoardText::tr("center"), BoardText::tr("right")},
      {BoardText::tr("lower left"), BoardText::tr("bottom"), BoardText::tr("lower right")}};
  return names[std::clamp(row, 0, 2)][std::clamp(column, 0, 2)];
}

QString tiltText(BoardTilt tilt) {
  switch (tilt) {
  case BoardTilt::LeftNear:
    return BoardText::tr("left side closer to the camera");
  case BoardTilt::RightNear:
    return BoardText::tr("right side closer to the camera");
  case BoardTilt::TopNear:
    return BoardText::tr("upper side closer to the camera");
  case BoardTilt::BottomNear:
    return BoardText::tr("lower side closer to the camera");
  case BoardTilt::Flat:
    break;
  }
  return BoardText::tr("facing the camera");
}

QString adviceText(const BoardGuideState::PerCamera& camera) {
  if (camera.imageWidth == 0) {
    return BoardText::tr("No image yet");
  }
  switch (camera.lensGuidance.advice) {
  case GuidanceAdvice::ShowCalibrationBoard:
    return BoardText::tr("Show the whole board");
  case GuidanceAdvice::MoveTo:
    return BoardText::tr("Move the board to: %1")
        .arg(regionText(camera.lensGuidance.requestedRegion));
  case GuidanceAdvice::TiltTo:
    return BoardText::tr("Turn the board: %1").arg(tiltText(camera.lensGuidance.tilt));
  case GuidanceAdvice::ComeNearer:
    return BoardText::tr("Move the board closer");
  case GuidanceAdvice::HoldStill:
    return BoardText::tr("Hold the board still");
  case GuidanceAdvice::Sharpen:
    return BoardText::tr("The image is blurred: focus the lens or add light");
  case GuidanceAdvice::Finished:
    break;
  }
  return BoardText::tr("✓ Done");
}

QString cameraPairText(const BoardCalibrator& calibrator, const RigGuidance::State& state) {
  if (state.firstCamera < 0 || state.secondCamera < 0) {
    return BoardText::tr("✓ The cameras share enough views of the board");
  }
  return BoardText::tr(
             "Show the board to %1 and %2 at the same time, hold it still, then repeat elsewhere")
      .arg(calibrator.nameOf(static_cast<std::size_t>(state.firstCamera)),
           calibrator.nameOf(static_cast<std::size_t>(state.secondCamera)));
}

QString sharpnessText(const BoardGuideState::PerCamera& camera, const GuidanceSettings& settings) {
  if (!camera.detection) {
    return BoardText::tr("board not visible");
  }
  const QString edges = pixelText(camera.detection->edgeWidthPx);
  return camera.detection->edgeWidthPx > settings.softEdgeWidthFraction * camera.imageWidth
             ? BoardText::tr("⚠ blurred: edges are %1 wide").arg(edges)
             : BoardText::tr("sharp: edges are %1 wide").arg(edges);
}

QString lensAccuracyText(const BoardGuideState::PerCamera& camera,
                         const GuidanceSettings& settings) {
  if (!camera.lensGuidance.projectionSigmaPx) {
    return BoardText::tr("%1 views; at least %2 are needed")
        .arg(QString::number(camera.lensGuidance.viewCount), QString::number(settings.minViews));
  }
  return BoardText::tr("%1 views, accuracy %2 (goal: %3)")
      .arg(QString::number(camera.lensGuidance.viewCount),
           pixelText(*camera.lensGuidance.projectionSigmaPx, 2),
           pixelText(settings.requiredProjectionSigmaPx, 2));
}

QString visibilityText(const BoardGuideState::PerCamera& camera) {
  return camera.imageWidth == 0 ? BoardText::tr("No image yet")
         : camera.detection     ? BoardText::tr("● board visible")
                                : BoardText::tr("○ board not visible");
}

QString positionAccuracyText(const BoardGuideState::PerCamera& camera) {
  const QString views = QString::number(camera.pairViewCount);
  return camera.positionSigma
             ? BoardText::tr("%1 views, position accuracy %2")
                   .arg(views, lengthText(*camera.positionSigma, LengthScale::Millimeters, 2))
             : BoardText::tr("%1 views shared with other cameras").arg(views);
}

QString guessedBoardText(const BoardGuess& guess) {
  const BoardDescription& board = guess.board;
  const QString columns = QString::number(board.columns);
  const QString rows = QString::number(board.rows);
  QStringList parts;
  parts << (board.kind == BoardDescription::Kind::Chessboard
                ? BoardText::tr("a chessboard with %1 × %2 inner corners").arg(columns, rows)
                : BoardText::tr("a ChArUco board with %1 × %2 squares, %3")
                      .arg(columns, rows, QString::fromStdString(board.dictionary)));
  if (board.usesLegacyLayout) {
    parts << BoardText::tr("legacy layout");
  }
  if (board.isInverted) {
    parts << BoardText::tr("inverted colors");
  }
  return parts.join(QStringLiteral(", "));
}

QString proposalQuestion(const BoardGuess& guess) {
  const QString images = QString::number(guess.imageCount);
  const QString searched = QString::number(guess.searchedImageCount);
  return guess.isMirrored
             ? BoardText::tr("%1 of the %2 searched images show %3, but mirrored. To "
                             "correct this, change “Mirrored” in the panel Cameras for "
                             "the cameras that took these images. Use this board?")
                   .arg(images, searched, guessedBoardText(guess))
             : BoardText::tr("%1 of the %2 searched images show %3. Use this board?")
                   .arg(images, searched, guessedBoardText(guess));
}

QString mirroredVideosQuestion(const BoardCalibrator& calibrator) {
  QStringList names;
  for (const std::size_t camera : calibrator.mirroredVideos().mirroredCameras) {
    names << calibrator.nameOf(camera);
  }
  const QString cameras = names.join(QStringLiteral(", "));
  return calibrator.mirroredVideos().cause == MirroredVideos::Cause::Videos
             ? BoardText::tr("The video of %1 is mirrored: it shows the board mirrored, but "
                             "another camera shows the board the right way round.")
                   .arg(cameras)
             : BoardText::tr(
                   "The board or the video of %1 is mirrored: no camera shows the board the right "
                   "way round. Check whether writing in the images is readable.")
                   .arg(cameras);
}

QString outcomeText(const BoardCalibrator& calibrator, const BoardOutcome& outcome) {
  QStringList lines;
  if (outcome.lenses) {
    addLenses(calibrator, outcome, lines);
  }
  if (outcome.extrinsicsError) {
    lines << QStringLiteral("⚠ ") + BoardText::tr("The camera positions could not be computed: %1")
                                        .arg(errorText(*outcome.extrinsicsError));
  }
  if (outcome.extrinsics) {
    addPlaces(calibrator, *outcome.extrinsics, lines);
    lines << (outcome.accuracy ? accuracyText(*outcome.accuracy)
                               : BoardText::tr("The accuracy cannot be estimated, because two "
                                               "cameras rarely saw the board at the same time."));
    QStringList names;
    for (std::size_t k = 0; k < outcome.extrinsics->cameras.size(); ++k) {
      names << calibrator.nameOf(k);
    }
    for (const DetectedFault& fault : outcome.extrinsics->faults) {
      lines << QStringLiteral("⚠ ") + faultText(fault, names);
    }
  }
  return lines.join(QLatin1Char('\n'));
}

} // namespace dewpoint::ui
