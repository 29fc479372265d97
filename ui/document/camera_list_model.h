// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/name_list_model.h"

namespace dewpoint::ui {

class Document;

/// Cameras of the project by name, in their order; one model for every panel, combo box and
/// palette. `Selection` knows which one is selected.
class CameraListModel : public NameListModel {
  Q_OBJECT
public:
  explicit CameraListModel(const Document& document, QObject* parent = nullptr);

  /// Returns the name of a camera, or "camera 2" if it has none.
  QString nameOf(int camera) const;
  /// In another language.
  void retranslateUi() { refresh(); }

private:
  void refresh();

  const Document& document_;
};

} // namespace dewpoint::ui
