// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_learning.h"
#include "core/session/run/background_images.h"
#include "core/session/snapshot/snapshot.h"
#include "core/setup/clicks/click_learning.h"
#include "ui/jobs/latest_job.h"

#include <QObject>
#include <QRectF>

#include <functional>
#include <memory>

namespace dewpoint::ui {

class Document;

/// Learns a target's color from clicks and boxes in the images (`learnFromClicks()`) and assesses
/// it. The work runs in another thread. The result is an undoable step of the document.
class ColorLearner : public QObject {
  Q_OBJECT
public:
  explicit ColorLearner(Document& document, QObject* parent = nullptr);

  /// Sets the snapshot whose images are shown. The colors are learned from its images.
  void setSnapshot(TrackSnapshotPtr snapshot) { snapshot_ = std::move(snapshot); }
  /// Sets the index of the target whose color is learned; -1 for a new target.
  void setTarget(int target) { target_ = target; }

  enum class SampleAction { Replace, Add, Exclude };
  /// Handles a click (`region` has an empty size) or a box in a camera image, in pixels.
  void learnFrom(int camera, const QRectF& region, SampleAction action);
  /// Removes a sample (`withoutSample()`) and learns the color again from the remaining ones. If no
  /// click remains, the color stays unchanged.
  void removeSample(int index);
  bool isBusy() const { return learning_.isRunning(); }
  /// Assesses the target's color in the images shown.
  void assessLearnedColor();

Q_SIGNALS:
  /// Emitted when a color was learned. `isNew` is true if the target did not exist before.
  void colorLearned(int target, bool isNew);
  /// Emitted with everything that was learned from clicks, before the color is assessed.
  void learningResultReady(const dewpoint::setup::ClickLearningResult& result);
  void colorAssessed(const dewpoint::color::ColorAssessment& assessment);
  void failed(const QString& sentence);
  void busyChanged(bool busy);

private:
  using Work = std::function<std::function<void()>()>;
  struct Scene;
  Scene scene() const;
  std::vector<cv::Mat> images() const;
  std::vector<cv::Mat> backgroundImages() const;
  /// Runs `work` in another thread, then runs the function it returns in the GUI thread. A newer
  /// call replaces an earlier one.
  void start(Work work);
  void applyResult(int target, const setup::ClickLearningResult& result, const QString& step);

  Document& document_;
  TrackSnapshotPtr snapshot_;
  int target_ = 0;
  LatestJob learning_{LatestJob::SupersededJob::Dropped};
};

} // namespace dewpoint::ui
