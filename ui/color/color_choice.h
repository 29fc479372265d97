// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <QWidget>

#include <vector>

class QButtonGroup;
class QHBoxLayout;
class QToolButton;

namespace dewpoint::ui {

/// Buttons that select which color of a target is shown, and a button that removes a color. Hidden
/// for a target with one color.
class ColorChoice : public QWidget {
  Q_OBJECT
public:
  explicit ColorChoice(QWidget* parent = nullptr);

  /// Shows the colors of a target. Keeps the selection if their number is unchanged; otherwise
  /// selects the first.
  void setColors(const ColorRanges& colors);
  /// Index of the selected color.
  int chosen() const { return chosen_; }
  void retranslateUi();

Q_SIGNALS:
  /// The user selected another color.
  void chosenChanged();
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
