// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_learning.h"
#include "core/session/run/background_images.h"
#include "core/session/snapshot/snapshot.h"
#include "core/setup/clicks/click_lesson.h"
#include "ui/jobs/latest_job.h"

#include <QObject>
#include <QRectF>

#include <functional>
#include <memory>

namespace dewpoint::ui {

class Document;

/// Learns the color of a target from clicks and boxes in the images (`learnFromClicks()`), and
/// assesses it. The work runs in another thread; the result is an undoable step of the document.
class ColorLearner : public QObject {
  Q_OBJECT
public:
  explicit ColorLearner(Document& document, QObject* parent = nullptr);

  /// Sets the images to learn from: those shown.
  void setSnapshot(TrackSnapshotPtr snapshot) { snapshot_ = std::move(snapshot); }
  /// Index of the target whose color is learned; -1: a new target.
  void setTarget(int target) { target_ = target; }

  enum class SampleAction { Replace, Add, Exclude };
  /// Handles a click (`region` has an empty size) or a box in the image of a camera, pixels.
  void point(int camera, const QRectF& region, SampleAction action);
  /// Removes a sample (`withoutSample()`) and learns the color from the remaining ones. The color
  /// stays as it is if no click remains.
  void removeSample(int index);
  bool isBusy() const { return learning_.isRunning(); }
  /// Assesses the color of the target in the images shown.
  void assess();

Q_SIGNALS:
  /// A color was learned. `isNew`: the target did not exist before.
  void learned(int target, bool isNew);
  /// Result of learning from clicks, emitted before the color is assessed.
  void taught(const dewpoint::setup::ClickLesson& lesson);
  void assessed(const dewpoint::color::ColorAssessment& assessment);
  void failed(const QString& sentence);
  void busyChanged(bool busy);

private:
  using Work = std::function<std::function<void()>()>;
  struct Scene;
  Scene scene() const;
  std::vector<cv::Mat> images() const;
  std::vector<cv::Mat> emptyRooms() const;
  /// Runs `work` in another thread, then the function it returns in the thread of the window. A
  /// newer call replaces an earlier one.
  void start(Work work);
  void applyResult(int target, const setup::ClickLesson& lesson, const QString& step);

  Document& document_;
  TrackSnapshotPtr snapshot_;
  int target_ = 0;
  LatestJob learning_{LatestJob::Overtaken::Dropped};
};

} // namespace dewpoint::ui
