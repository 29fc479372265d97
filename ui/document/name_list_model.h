// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QAbstractListModel>
#include <QStringList>

namespace dewpoint::ui {

/// A list of names. A name that changes alone leaves selections of the list as they are.
class NameListModel : public QAbstractListModel {
  Q_OBJECT
public:
  using QAbstractListModel::QAbstractListModel;

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

protected:
  void setNames(const QStringList& names);

private:
  QStringList names_;
};

} // namespace dewpoint::ui
