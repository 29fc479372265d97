// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/name_list_model.h"

namespace dewpoint::ui {

class Document;

/// Targets of the project by name, each with a chip in the color it has in all views; one model for
/// every panel, combo box and palette. `Selection` knows which one is selected.
class TargetListModel : public NameListModel {
  Q_OBJECT
public:
  explicit TargetListModel(const Document& document, QObject* parent = nullptr);

  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
  void refresh();

  const Document& document_;
};

} // namespace dewpoint::ui
