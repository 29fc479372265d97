// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QLineEdit>

namespace dewpoint::ui {

/// Field for a path or an address. While it is not edited, text that does not fit is truncated at
/// its beginning with an ellipsis, because paths usually differ at the end. The tooltip then starts
/// with the full text.
class PathField : public QLineEdit {
  Q_OBJECT
public:
  using QLineEdit::QLineEdit;

  /// Returns the text shown while the field is not edited.
  QString shownText() const;

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  QRect textRect() const;
};

} // namespace dewpoint::ui
