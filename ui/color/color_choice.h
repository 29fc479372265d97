// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <QWidget>

#include <vector>

class QButtonGroup;
class QHBoxLayout;
class QToolButton;

namespace dewpoint::ui {

/// Which color of a target of several is shown, and a way to take one away. Not shown for a target
/// of one color.
class ColorChoice : public QWidget {
  Q_OBJECT
public:
  explicit ColorChoice(QWidget* parent = nullptr);

  /// Shows the colors of a target; the choice stays where there are as many still.
  void setColors(const ColorRanges& colors);
  /// An index of the colors.
  int chosen() const { return chosen_; }
  void retranslate();

Q_SIGNALS:
  /// By the user.
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
