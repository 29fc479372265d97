// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_learning.h"
#include "core/session/snapshot/snapshot.h"
#include "core/setup/clicks/click_learning.h"
#include "ui/color/color_learner.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QTimer;

namespace dewpoint::ui {

class BoxPicker;
class ColorChoice;
class ColorPicker;
class ColorSampleList;
class FollowAllButton;
class ImageHistogramJob;
class Document;
class ImagePickTool;
class LearnModes;

/// Panel for the color of the selected target: picker, color samples and assessment. If the method
/// tracks boxes, a click sets the target's box instead of its color.
class ColorPanel : public QWidget {
  Q_OBJECT
public:
  /// Creates the panel. `pick` provides the clicks in the camera images.
  ColorPanel(Document& document, ImagePickTool& pick, QWidget* parent = nullptr);

  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Sets the target whose color is shown. If it is -1, the next click creates a new target.
  void setTarget(int target);
  /// Sets whether a plain click in a view learns the color.
  void setPicking(bool picking);
  /// Sets whether plain clicks in images have another purpose, for example on a calibration page.
  /// The panel then waits for a click, and shows a hint about it, only if the user requested this.
  void setClicksUsedElsewhere(bool taken);
  /// Sets whether the panel is visible. Colors are assessed only while it is visible.
  void setPanelVisible(bool visible);
  bool isPicking() const { return picking_; }
  /// Returns whether there is a target whose color is shown.
  bool hasTarget() const;
  /// Returns whether the next click adds a further target.
  bool clickAddsTarget() const;
  /// Returns whether a click sets a target's box instead of its color.
  bool targetsAreBoxes() const;

Q_SIGNALS:
  /// Emitted when isPicking() or clickAddsTarget() has changed.
  void pickingChanged();
  /// Emitted when a color was learned from images and tracking can start.
  void colorLearned(int target, bool isNew);
  void failed(const QString& sentence);

private:
  void retranslateUi();
  void refresh();
  /// Returns the effect of a click with these modifiers.
  ColorLearner::SampleAction actionOf(Qt::KeyboardModifiers modifiers) const;
  /// Returns the hint about what to click, shown over the images.
  QString hint() const;
  void connectLearner();
  /// Returns whether there is nothing to track yet. The panel then expects a click on the object to
  /// track, even if the user has not pressed *Learn*.
  bool expectsClick() const;
  void showBox();
  void handlePick(int camera, const QRectF& region, Qt::KeyboardModifiers modifiers);
  void editRange(const ColorRange& range);
  void removeColor(int color);
  void updateAssessment();
  void showAssessment(const ColorAssessment& assessment);
  void assessNow();
  void keepAssessmentCurrent();
  void clearRegions();
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
  bool wasAdding_ = false; ///< clickAddsTarget() when pickingChanged() was last emitted
  bool clicksTaken_ = false;
  /// Effect of a click while picking.
  ColorLearner::SampleAction mode_ = ColorLearner::SampleAction::Replace;
  ColorAssessment assessment_;
  ColorRanges colors_;                     ///< colors of the target shown
  bool inFront_ = false;                   ///< whether the panel is visible, not behind another tab
  bool assessed_ = false;                  ///< whether the assessment matches the colors shown
  std::int64_t assessedFrame_ = -1;        ///< frame that was assessed
  bool outlined_ = false;                  ///< distractors are outlined in the views
  std::vector<setup::FoundOutline> found_; ///< further regions of the target, also outlined
  std::optional<double> shownRadius_; ///< radius found by the last clicks on this target, meters
  bool isPart_ = false;               ///< the last clicks hit part of a larger object of this color
  QTimer* assessSoon_;
  ImageHistogramJob* survey_;
};

} // namespace dewpoint::ui
