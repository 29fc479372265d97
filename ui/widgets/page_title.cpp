// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/page_title.h"

#include <QLabel>

namespace dewpoint::ui {

QLabel* makePageTitle(QWidget* parent) {
  auto* title = new QLabel(parent);
  QFont font = title->font();
  font.setBold(true);
  title->setFont(font);
  return title;
}

} // namespace dewpoint::ui
