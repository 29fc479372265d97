// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/color/color_learner.h"

#include <QWidget>

#include <array>
#include <optional>

class QToolButton;

namespace dewpoint::ui {

/// Buttons that select the effect of a click in a camera image: learn the target's color, add a
/// sample, or exclude a color. At most one button is down.
class LearnModes : public QWidget {
  Q_OBJECT
public:
  using Mode = std::optional<ColorLearner::SampleAction>; ///< effect of a click; empty if a click
                                                          ///< only selects

  explicit LearnModes(QWidget* parent = nullptr);

  /// Shows the button of a mode as pressed, without emitting `modeChosen()`.
  void setMode(Mode mode);
  /// Enables or disables the buttons. `canAdd` is true if there is a target to which samples can be
  /// added, `canExclude` if this target already has samples.
  void setRefinementEnabled(bool canAdd, bool canExclude);
  bool offersMode(ColorLearner::SampleAction mode) const;
  /// Sets whether a click sets a target's box. If so, the buttons for adding and excluding are not
  /// available.
  void setTargetsAreBoxes(bool targetsAreBoxes);
  void retranslateUi();

  /// Returns the hint for a mode, shown over the images. It names only the clicks that are possible
  /// now.
  QString hintOf(ColorLearner::SampleAction mode) const;

Q_SIGNALS:
  /// Emitted when the user presses a button.
  void modeChosen(dewpoint::ui::LearnModes::Mode mode);

private:
  void showHints();

  std::array<QToolButton*, 3> buttons_{}; ///< indexed by SampleAction
  bool canAdd_ = false;
  bool canExclude_ = false;
  bool targetsAreBoxes_ = false;
};

} // namespace dewpoint::ui
