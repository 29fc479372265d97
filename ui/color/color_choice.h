// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <QWidget>

#include <vector>

class QButtonGroup;
class QHBoxLayout;
class QToolButton;

namespace dewpoint::ui {

/// Buttons that select which of a target's colors is shown, and a button that removes a color.
/// Hidden for a target with one color.
class ColorChoice : public QWidget {
  Q_OBJECT
public:
  explicit ColorChoice(QWidget* parent = nullptr);

  /// Shows the colors of a target. Keeps the selection if the number of colors is unchanged;
  /// otherwise selects the first color.
  void setColors(const ColorRanges& colors);
  /// Returns the index of the selected color.
  int selectedColor() const { return chosen_; }
  void retranslateUi();

Q_SIGNALS:
  /// Emitted when the user selects another color.
  void selectedColorChanged();
  void removeRequested(int color);

private:
  void updateButtons();

  ColorRanges colors_;
  int chosen_ = 0;
  QButtonGroup* group_;
  QHBoxLayout* row_;
  std::vector<QToolButton*> buttons_;
  QToolButton* remove_;
};

} // namespace dewpoint::ui
