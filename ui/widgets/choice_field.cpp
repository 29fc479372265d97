// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/choice_field.h"

#include "ui/widgets/number_field.h"

#include <QComboBox>
#include <QSignalBlocker>

#include <algorithm>

namespace dewpoint::ui {

QComboBox* makeChoice(const char* name, QWidget* parent) {
  auto* choice = new QComboBox(parent);
  choice->setObjectName(QLatin1String(name));
  makeNarrow(*choice);
  return choice;
}

void setTexts(QComboBox& box, const QStringList& texts) {
  const QSignalBlocker quiet(box);
  const int chosen = std::max(0, box.currentIndex());
  box.clear();
  box.addItems(texts);
  box.setCurrentIndex(chosen);
}

} // namespace dewpoint::ui
