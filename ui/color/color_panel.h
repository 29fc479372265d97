// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_learning.h"
#include "core/session/run/snapshot.h"
#include "ui/jobs/background_job.h"

#include <QElapsedTimer>
#include <QWidget>

#include <memory>
#include <vector>

class QLabel;
class QListWidget;
class QPushButton;
class QTimer;
class QToolButton;

namespace dewpoint::color {
struct ColorHistogram;
} // namespace dewpoint::color

namespace dewpoint::ui {

class BoxPicker;
class CameraView;
class ColorPicker;
class ColorLearner;
class Document;
class ImagePickOverlay;

/// The color of the chosen target: picker, samples it was learned from, and what to expect of it.
class ColorPanel : public QWidget {
  Q_OBJECT
public:
  explicit ColorPanel(Document& document, QWidget* parent = nullptr);

  /// From now on a person can point at things in this view; views that are gone are forgotten.
  void attach(int camera, CameraView* view);
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// The target whose color is shown; -1: the next click makes a new one.
  void setTarget(int target);
  /// Whether a plain click in a view teaches the color.
  void setPicking(bool picking);
  /// Whether the panel can be seen: only then colors are judged.
  void setInFront(bool inFront);
  bool isPicking() const { return picking_; }

Q_SIGNALS:
  void pickingChanged(bool picking);
  /// A color was learned from images: time to track it.
  void learned(int target, bool isNew);
  void cameraChosen(int camera);
  /// A click in the image of a camera that teaches nothing, pixels.
  void pointed(int camera, const QPointF& pixel);
  void failed(const QString& sentence);

private:
  void say();
  void refresh();
  void refreshSamples();
  void connectTeacher();
  /// Whether the method follows boxes: then a box is pointed at in place of a color.
  bool takesBoxes() const;
  /// Whether a plain click is expected although nobody asked for it: there is nothing to follow.
  bool mustPoint() const;
  void showBox();
  void pickedIn(int camera, const QRectF& region, Qt::KeyboardModifiers modifiers);
  void editRange(const ColorRange& range);
  void sayVerdict();
  void showVerdict(const ColorVerdict& verdict);
  void judgeNow();
  void keepVerdictCurrent();
  void clearRegions();
  void surveyImages();
  void removeSample();

  Document& document_;
  ColorLearner* teacher_;
  BoxPicker* boxes_;
  QLabel* name_;
  QToolButton* learn_;
  ColorPicker* picker_;
  QLabel* verdict_;
  QLabel* samplesTitle_;
  QListWidget* samples_;
  QPushButton* remove_;
  std::vector<std::pair<int, ImagePickOverlay*>> layers_;
  TrackSnapshotPtr snapshot_;
  int target_ = 0;
  bool picking_ = false;
  ColorVerdict said_;
  bool inFront_ = false;          ///< the panel is seen, not behind another tab
  bool judged_ = false;           ///< the verdict is about the range shown
  std::int64_t judgedFrame_ = -1; ///< and about this frame
  bool outlined_ = false;         ///< look-alikes are outlined in the views
  QTimer* judgeSoon_;
  QElapsedTimer sinceSurvey_;
  BackgroundJob survey_;
};

} // namespace dewpoint::ui
