// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QLabel>

namespace dewpoint::ui {

/// Single line of text that uses the available width. Text that does not fit is truncated at its
/// end with an ellipsis; the tooltip shows the full text.
class ElidedLabel : public QLabel {
public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  void setFullText(const QString& text);
  const QString& fullText() const { return full_; }

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void elide();

  QString full_;
};

} // namespace dewpoint::ui
