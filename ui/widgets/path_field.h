// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QLineEdit>

namespace dewpoint::ui {

/// A field for a path or an address. While nobody edits it, what does not fit is cut at its
/// beginning, with an ellipsis: the end tells files apart. The tooltip then begins with all of it.
class PathField : public QLineEdit {
  Q_OBJECT
public:
  using QLineEdit::QLineEdit;

  /// What stands in the field while nobody edits it.
  QString shownText() const;

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  QRect textRect() const;
};

} // namespace dewpoint::ui
