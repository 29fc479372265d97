// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/color/color_learner.h"

#include <QWidget>

#include <array>
#include <optional>

class QToolButton;

namespace dewpoint::ui {

/// Buttons for what a click in a camera image does: learn the color of the target, add a sample of
/// it, or exclude what is not it. At most one is down.
class LearnModes : public QWidget {
  Q_OBJECT
public:
  using Mode = std::optional<ColorLearner::SampleAction>; ///< nothing: a click selects

  explicit LearnModes(QWidget* parent = nullptr);

  /// Shows a mode without announcing it.
  void setMode(Mode mode);
  /// Whether there is a target whose samples can become more, and whether it has some already, from
  /// which something can be excluded.
  void setRefinable(bool canAdd, bool canExclude);
  bool offers(ColorLearner::SampleAction mode) const;
  /// Whether a click gives the target a box; then there is nothing to add or to exclude.
  void setTakesBoxes(bool takesBoxes);
  void retranslate();

  /// What to do in a mode, for a line over the images.
  static QString hintOf(ColorLearner::SampleAction mode);

Q_SIGNALS:
  /// The user pressed a button.
  void modeChosen(dewpoint::ui::LearnModes::Mode mode);

private:
  void showHints();

  std::array<QToolButton*, 3> buttons_{}; ///< in the order of SampleAction
  bool canAdd_ = false;
  bool canExclude_ = false;
  bool takesBoxes_ = false;
};

} // namespace dewpoint::ui
