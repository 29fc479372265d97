// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/target_list_model.h"

#include "core/project/project.h"
#include "ui/document/document.h"
#include "ui/style/theme.h"
#include "ui/widgets/named_widgets.h"

namespace dewpoint::ui {

TargetListModel::TargetListModel(const Document& document, QObject* parent)
    : NameListModel(parent), document_(document) {
  connect(&document_, &Document::replaced, this, &TargetListModel::refresh);
  connect(&document_, &Document::changed, this, &TargetListModel::refresh);
  refresh();
}

QVariant TargetListModel::data(const QModelIndex& index, int role) const {
  if (role == Qt::DecorationRole && checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return colorChip(targetColor(index.row()), 14);
  }
  return NameListModel::data(index, role);
}

void TargetListModel::refresh() {
  QStringList names;
  for (const Target& target : document_.project().targets) {
    names << QString::fromStdString(target.name);
  }
  setNames(names);
}

} // namespace dewpoint::ui
