// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recording/take_text.h"

#include "core/session/take/take_recorder.h"
#include "core/session/take/take_replay.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cstdint>

namespace dewpoint::ui {

namespace {

std::int64_t bytesOf(const TakeStatus& take) {
  std::int64_t bytes = 0;
  for (const auto& camera : take.cameras) {
    bytes += camera.counts.byteCount;
  }
  return bytes;
}

std::int64_t droppedOf(const TakeStatus& take) {
  std::int64_t dropped = 0;
  for (const auto& camera : take.cameras) {
    dropped += camera.counts.droppedImageCount;
  }
  return dropped;
}

QString sizeText(std::uint64_t bytes) {
  return QLocale().formattedDataSize(static_cast<qint64>(bytes), 0, QLocale::DataSizeSIFormat);
}

/// How long the disk lasts at the present rate; empty while that is not known.
QString timeLeft(const TakeStatus& take) {
  constexpr double kKnownAfter = 2.0; // seconds
  constexpr double kLongest = 99.0 * 3600.0;
  const auto bytes = static_cast<double>(bytesOf(take));
  if (take.durationSeconds < kKnownAfter || bytes <= 0.0) {
    return {};
  }
  const double left = static_cast<double>(take.freeBytes) * take.durationSeconds / bytes;
  return left > kLongest
             ? QString()
             : QCoreApplication::translate("TakeText", "%1 left").arg(minutesAndSecondsText(left));
}

} // namespace

QString takeSummaryText(const TakeStatus& take) {
  QStringList parts{
      QCoreApplication::translate("TakeText", "Recording take %1").arg(take.takeNumber),
      minutesAndSecondsText(take.durationSeconds)};
  const auto dropped = static_cast<int>(droppedOf(take));
  parts += QCoreApplication::translate("TakeText", "%n dropped image(s)", nullptr, dropped);
  parts += QCoreApplication::translate("TakeText", "%1 free").arg(sizeText(take.freeBytes));
  if (const QString left = timeLeft(take); !left.isEmpty()) {
    parts += left;
  }
  return parts.join(QStringLiteral(" · "));
}

QString takeDetailsText(const TakeStatus& take) {
  QStringList lines;
  for (const auto& camera : take.cameras) {
    const RecordedCounts& counts = camera.counts;
    lines += QCoreApplication::translate("TakeText", "%1: %2 images, %3, %4 dropped, %5")
                 .arg(QString::fromStdString(camera.name))
                 .arg(counts.imageCount)
                 .arg(rateText(counts.framesPerSecond))
                 .arg(counts.droppedImageCount)
                 .arg(sizeText(static_cast<std::uint64_t>(counts.byteCount)));
  }
  if (const QString before = preRollText(take); !before.isEmpty()) {
    lines += before;
  }
  return lines.join(QLatin1Char('\n'));
}

QString preRollText(const TakeStatus& take) {
  if (take.preRollSeconds <= 0.0) {
    return {};
  }
  const QString time = secondsText(take.preRollSeconds, 1);
  const bool isShortened = std::ranges::any_of(
      take.cameras, [](const auto& camera) { return camera.preRoll.isShortened; });
  return isShortened ? QCoreApplication::translate("TakeText",
                                                   "The take contains %1 from before you pressed "
                                                   "Record. There was not enough memory for more.")
                           .arg(time)
                     : QCoreApplication::translate(
                           "TakeText", "The take contains %1 from before you pressed Record.")
                           .arg(time);
}

QString replayText(const ReplayComparison& found) {
  QStringList parts;
  if (found.frameCountBeforeTake > 0) {
    parts += QCoreApplication::translate(
        "TakeText", "The run began before the take, so the run cannot be tracked again from its "
                    "beginning. To avoid this, restart the run while you record.");
  } else if (found.isBitIdentical()) {
    parts += QCoreApplication::translate(
                 "TakeText",
                 "Tracking the take gives exactly the results of the live run in all %1 frames.")
                 .arg(found.liveFrameCount);
  } else {
    parts += QCoreApplication::translate(
                 "TakeText",
                 "%1 of %2 frames differ from the live run, the first one is frame %3. Positions "
                 "differ by up to %4.")
                 .arg(found.differingFrameCount)
                 .arg(found.liveFrameCount)
                 .arg(frameNumberText(found.firstDifferingFrame.value_or(0)),
                      lengthText(found.largestPositionDifference));
  }
  if (found.incompleteFrameCount > 0) {
    parts += QCoreApplication::translate("TakeText",
                                         "Images of %1 frames were dropped, the first in frame %2.")
                 .arg(found.incompleteFrameCount)
                 .arg(frameNumberText(found.firstIncompleteFrame.value_or(0)));
  }
  for (const ResultRange& range : found.framesWithOtherSettings) {
    parts +=
        QCoreApplication::translate("TakeText", "Frames %1 to %2 were tracked with other settings.")
            .arg(frameNumberText(range.firstFrame), frameNumberText(range.lastFrame));
  }
  if (found.hasTimeBudget) {
    parts += QCoreApplication::translate(
        "TakeText", "A time budget is set, so results depend on the speed of the computer.");
  }
  if (!found.changedCameras.empty()) {
    QStringList names;
    for (const std::string& name : found.changedCameras) {
      names += QString::fromStdString(name);
    }
    parts += QCoreApplication::translate("TakeText",
                                         "The images of %1 are stored with slightly different "
                                         "colors, because the camera sends them uncompressed.")
                 .arg(names.join(QStringLiteral(", ")));
  }
  return parts.join(QLatin1Char(' '));
}

QString takeProblemText(const TakeStatus& take) {
  if (take.problem) {
    return errorText(*take.problem);
  }
  for (const auto& camera : take.cameras) {
    if (camera.counts.problem) {
      return errorText(*camera.counts.problem);
    }
  }
  return {};
}

} // namespace dewpoint::ui
