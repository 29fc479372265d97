// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/name_list_model.h"

namespace dewpoint::ui {

int NameListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(names_.size());
}

QVariant NameListModel::data(const QModelIndex& index, int role) const {
  const bool isText =
      role == Qt::DisplayRole || role == Qt::EditRole || role == Qt::AccessibleTextRole;
  return isText && checkIndex(index, CheckIndexOption::IndexIsValid) ? names_.at(index.row())
                                                                     : QVariant();
}

void NameListModel::setNames(const QStringList& names) {
  if (names.size() != names_.size()) {
    beginResetModel();
    names_ = names;
    endResetModel();
    return;
  }
  for (int row = 0; row < names.size(); ++row) {
    if (names[row] != names_[row]) {
      names_[row] = names[row];
      Q_EMIT dataChanged(index(row), index(row));
    }
  }
}

} // namespace dewpoint::ui
