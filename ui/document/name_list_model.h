// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QAbstractListModel>
#include <QStringList>

namespace dewpoint::ui {

/// List model of names. If the names change but their number does not, selections in the list are
/// preserved.
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
