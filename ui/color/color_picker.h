// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <QWidget>

#include <array>

class QDoubleSpinBox;
class QLabel;

namespace dewpoint::color {
struct ColorHistogram;
} // namespace dewpoint::color

namespace dewpoint::ui {

class HueRing;
class RangeBar;

/// Shows and edits a color range, by dragging on a hue ring and bars or by entering numbers.
class ColorPicker : public QWidget {
  Q_OBJECT
public:
  explicit ColorPicker(QWidget* parent = nullptr);

  /// Shows a range without emitting `rangeEdited()`.
  void setRange(const ColorRange& range);
  const ColorRange& range() const { return range_; }
  void setHistogram(const ColorHistogram& histogram);

Q_SIGNALS:
  void rangeEdited(const dewpoint::color::ColorRange& range);
  /// Emitted when a drag has ended. The next change is a new undo step.
  void editingFinished();

private:
  QDoubleSpinBox* addBox(const char* name, double maximum, double step, int decimals,
                         const QString& suffix);
  void retranslateUi();
  void showRange();
  void applyEdit(const ColorRange& range);

  ColorRange range_;
  HueRing* ring_;
  RangeBar* saturation_;
  RangeBar* intensity_;
  std::array<QLabel*, 3> labels_{};
  /// Lower and upper bounds of hue, saturation and intensity, in this order.
  std::array<QDoubleSpinBox*, 6> boxes_{};
};

} // namespace dewpoint::ui
