// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <vector>

namespace dewpoint::ui {

class Document;
class ParameterRow;

/// Sliders and exact numbers for the parameters of the method, made from their declarations. They
/// act through the document, so every change can be undone.
class ParameterPanel : public QWidget {
  Q_OBJECT
public:
  explicit ParameterPanel(Document& document, QWidget* parent = nullptr);

private:
  void rebuild();
  void addMethodChoice();
  void showValue(const QString& key);

  Document& document_;
  QWidget* form_ = nullptr;
  std::vector<ParameterRow*> rows_;
};

} // namespace dewpoint::ui
