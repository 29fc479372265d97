// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/method_choice.h"

#include "core/project/project.h"
#include "core/setup/method_obstacle.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/panels/method_item_delegate.h"
#include "ui/text/method_text.h"
#include "ui/widgets/number_field.h"

#include <QAbstractItemView>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStandardItemModel>

namespace dewpoint::ui {

namespace {

QStandardItem* headingItem(const QString& text) {
  auto* item = new QStandardItem(text);
  item->setFlags(Qt::NoItemFlags);
  return item;
}

QStandardItem* methodItem(const MethodTexts& words, MethodObstacle obstacle, bool isChosen) {
  auto* item = new QStandardItem(words.title);
  const QString why = methodObstacleText(obstacle);
  item->setData(words.name, Qt::UserRole);
  item->setData(why.isEmpty() ? words.description : why, MethodChoice::DescriptionRole);
  item->setData(words.paper, MethodChoice::PaperRole);
  item->setData(why.isEmpty() ? words.description : why, Qt::ToolTipRole);
  item->setData(why.isEmpty() ? words.description : why, Qt::AccessibleDescriptionRole);
  if (!why.isEmpty() && !isChosen) {
    item->setFlags(Qt::NoItemFlags);
  }
  return item;
}

} // namespace

MethodChoice::MethodChoice(QWidget* parent) : QComboBox(parent) {
  setObjectName(QStringLiteral("methodChoice"));
  makeNarrow(*this);
  setItemDelegate(new MethodItemDelegate(this));
  setMaxVisibleItems(100); // all of them: what is scrolled out of sight is not found
}

void MethodChoice::showMethods(const Project& project) {
  const QSignalBlocker quiet(this);
  auto* items = static_cast<QStandardItemModel*>(model());
  items->clear();
  QString heading;
  for (const Method* method : methodsInDisplayOrder()) {
    const MethodTexts words = methodTexts(*method);
    if (words.heading != heading) {
      heading = words.heading;
      items->appendRow(headingItem(heading));
    }
    const bool isChosen = project.method == method->name;
    items->appendRow(methodItem(words, setup::methodObstacle(project, *method), isChosen));
    if (isChosen) {
      setCurrentIndex(items->rowCount() - 1);
    }
  }
}

void MethodChoice::showPopup() {
  // Now, with the fonts in use; the frame and a scroll bar stand beside the rows.
  view()->setMinimumWidth(view()->sizeHintForColumn(0) + 2 * view()->frameWidth() +
                          view()->verticalScrollBar()->sizeHint().width());
  QComboBox::showPopup();
}

} // namespace dewpoint::ui
