// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/name_list_model.h"

#include <QColor>

#include <vector>

namespace dewpoint::ui {

class Document;

/// List model of the project's targets by name, each with a colored square in the color in which
/// all views draw the target. Every panel, combo box and palette uses this model. `Selection`
/// stores which target is selected.
class TargetListModel : public NameListModel {
  Q_OBJECT
public:
  explicit TargetListModel(const Document& document, QObject* parent = nullptr);

  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
  void refresh();

  const Document& document_;
  std::vector<QColor> onLight_; ///< colors of the squares in a light window
  std::vector<QColor> onDark_;  ///< colors of the squares in a dark window
};

} // namespace dewpoint::ui
