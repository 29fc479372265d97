// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/name_list_model.h"

namespace dewpoint::ui {

class Document;

/// The cameras of the project by name, in its order: one list for every panel, combo box and
/// palette. Which of them is selected is the Selection's.
class CameraListModel : public NameListModel {
  Q_OBJECT
public:
  explicit CameraListModel(const Document& document, QObject* parent = nullptr);

  /// The name of a camera; "camera 2" when it has none.
  QString nameOf(int camera) const;
  /// In another language.
  void retranslate() { refresh(); }

private:
  void refresh();

  const Document& document_;
};

} // namespace dewpoint::ui
