// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/help/legend_picture.h"

#include <QDialog>

class QGridLayout;

namespace dewpoint::ui {

/// Explains the signs over the images with a small picture and a sentence each. Not modal.
class OverlayLegend : public QDialog {
  Q_OBJECT
public:
  explicit OverlayLegend(QWidget* parent);

  /// Adds a row for each sign; the sentences follow a change of language.
  static void addRows(QGridLayout* rows, const std::vector<LegendSign>& signs, QWidget* parent);
};

} // namespace dewpoint::ui
