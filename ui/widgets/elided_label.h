// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QLabel>

namespace dewpoint::ui {

/// A line of text that takes the room there is: what does not fit is cut at its end, with an
/// ellipsis, and can be read in the tooltip.
class ElidedLabel : public QLabel {
public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  void setFullText(const QString& text);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void elide();

  QString full_;
};

} // namespace dewpoint::ui
