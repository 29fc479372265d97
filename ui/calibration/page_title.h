// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace dewpoint {

/// The title of a part of a page.
inline QLabel* makePageTitle(QWidget* parent) {
  auto* title = new QLabel(parent);
  QFont font = title->font();
  font.setBold(true);
  title->setFont(font);
  return title;
}

} // namespace dewpoint
