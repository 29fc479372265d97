// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/name_list_model.h"

namespace dewpoint::ui {

class Document;

/// List of the project's cameras by name, in project order. Every panel, combo box and palette uses
/// this model. `Selection` stores which camera is selected.
class CameraListModel : public NameListModel {
  Q_OBJECT
public:
  explicit CameraListModel(const Document& document, QObject* parent = nullptr);

  /// Returns the name of a camera, or "camera 2" if it has none.
  QString nameOf(int camera) const;
  /// Updates the names after a language change.
  void retranslateUi() { refresh(); }

private:
  void refresh();

  const Document& document_;
};

} // namespace dewpoint::ui
