// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/help/legend_picture.h"

#include <QDialog>

class QGridLayout;

namespace dewpoint::ui {

/// Dialog that explains the signs drawn over the images and in the bird's-eye view, with a small
/// image and a sentence for each. Not modal.
class OverlayLegend : public QDialog {
  Q_OBJECT
public:
  explicit OverlayLegend(QWidget* parent);

  /// Default width of the sentences in pixels.
  static constexpr int kSentenceWidthPx = 380;
  /// Adds a row for each sign to a layout. `sentenceWidth` is the width of the sentences in pixels.
  /// The sentences are updated when the language changes.
  static void addRows(QGridLayout* rows, const std::vector<LegendSign>& signs, QWidget* parent,
                      int sentenceWidth = kSentenceWidthPx);
};

} // namespace dewpoint::ui
