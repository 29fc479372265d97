// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/help/legend_picture.h"

#include <QDialog>

class QGridLayout;

namespace dewpoint::ui {

/// Explains the signs drawn over the images, with a small image and a sentence for each. Not modal.
class OverlayLegend : public QDialog {
  Q_OBJECT
public:
  explicit OverlayLegend(QWidget* parent);

  /// Adds a row for each sign. The sentences are updated when the language changes.
  static void addRows(QGridLayout* rows, const std::vector<LegendSign>& signs, QWidget* parent);
};

} // namespace dewpoint::ui
