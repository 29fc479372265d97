// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_learning.h"
#include "core/session/run/snapshot.h"
#include "core/setup/click_lesson.h"
#include "ui/color/color_learner.h"
#include "ui/jobs/background_job.h"

#include <QElapsedTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QTimer;

namespace dewpoint::color {
struct ColorHistogram;
} // namespace dewpoint::color

namespace dewpoint::ui {

class BoxPicker;
class ColorChoice;
class ColorPicker;
class ColorSampleList;
class FollowAllButton;
class Document;
class ImagePickTool;
class LearnModes;

/// The color of the chosen target: picker, samples it was learned from, and what to expect of it.
/// With methods that follow boxes, a click gives the target a box instead of a color.
class ColorPanel : public QWidget {
  Q_OBJECT
public:
  /// `pick`: gives the clicks in the images.
  ColorPanel(Document& document, ImagePickTool& pick, QWidget* parent = nullptr);

  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// The target whose color is shown; -1: the next click makes a new one.
  void setTarget(int target);
  /// Whether the color is learned from a plain click in a view.
  void setPicking(bool picking);
  /// Whether the panel can be seen: only then colors are assessed.
  void setInFront(bool inFront);
  bool isPicking() const { return picking_; }
  /// Whether there is a target whose color is shown.
  bool hasTarget() const;
  /// Whether a click gives the target a box instead of a color.
  bool takesBoxes() const;

Q_SIGNALS:
  void pickingChanged(bool picking);
  /// A color was learned from images: time to track it.
  void learned(int target, bool isNew);
  void failed(const QString& sentence);

private:
  void retranslateUi();
  void refresh();
  /// What a click with these keys held down does.
  ColorLearner::SampleAction actionOf(Qt::KeyboardModifiers modifiers) const;
  /// What to click, for a line over the images.
  QString hint() const;
  void connectLearner();
  /// Whether a plain click is expected although the button is off: there is nothing to follow.
  bool mustPoint() const;
  void showBox();
  void pickedIn(int camera, const QRectF& region, Qt::KeyboardModifiers modifiers);
  void editRange(const ColorRange& range);
  void removeColor(int color);
  void updateAssessment();
  void showAssessment(const ColorAssessment& assessment);
  void assessNow();
  void keepAssessmentCurrent();
  void clearRegions();
  void surveyImages();
  void removeSample(int sample);

  Document& document_;
  ImagePickTool& pick_;
  ColorLearner* learner_;
  BoxPicker* boxes_;
  QLabel* name_;
  LearnModes* modes_;
  ColorChoice* choice_;
  ColorPicker* picker_;
  QLabel* assessmentText_;
  FollowAllButton* followAll_;
  ColorSampleList* samples_;
  TrackSnapshotPtr snapshot_;
  int target_ = 0;
  bool picking_ = false;
  /// What a click does while picking.
  ColorLearner::SampleAction mode_ = ColorLearner::SampleAction::Replace;
  ColorAssessment assessment_;
  ColorRanges colors_;                     ///< of the target shown
  bool inFront_ = false;                   ///< the panel is seen, not behind another tab
  bool assessed_ = false;                  ///< the quality is of the colors shown
  std::int64_t assessedFrame_ = -1;        ///< and about this frame
  bool outlined_ = false;                  ///< distractors are outlined in the views
  std::vector<setup::FoundOutline> found_; ///< beside them: what is the target too
  std::optional<double> shownRadius_;      ///< meters, by the last clicks on this target
  bool isPart_ = false;                    ///< by the same: of something larger of its color
  QTimer* assessSoon_;
  QElapsedTimer sinceSurvey_;
  BackgroundJob survey_;
};

} // namespace dewpoint::ui
