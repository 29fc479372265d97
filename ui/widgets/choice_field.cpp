// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/choice_field.h"

#include "core/base/angle.h"
#include "ui/text/quantity_text.h"
#include "ui/widgets/number_field.h"

#include <QComboBox>
#include <QSignalBlocker>

#include <algorithm>

namespace dewpoint::ui {

QComboBox* makeChoiceField(const char* name, QWidget* parent) {
  auto* choice = new QComboBox(parent);
  choice->setObjectName(QLatin1String(name));
  makeNarrow(*choice);
  return choice;
}

void addRotationChoices(QComboBox& box) {
  for (const int degrees : {0, 90, 180, 270}) {
    box.addItem(angleText(degrees * base::kDegree, 0), degrees);
  }
}

void setChoices(QComboBox& box, const QStringList& texts) {
  ChoicesWithData choices;
  for (const QString& text : texts) {
    choices.emplace_back(text, QVariant());
  }
  setChoicesWithData(box, choices);
}

void setChoicesWithData(QComboBox& box, const ChoicesWithData& choices) {
  const QSignalBlocker quiet(box);
  const int chosen = std::max(0, box.currentIndex());
  box.clear();
  for (const auto& [text, data] : choices) {
    box.addItem(text, data);
  }
  box.setCurrentIndex(std::min(chosen, box.count() - 1));
}

} // namespace dewpoint::ui
