// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <QWidget>

class QDoubleSpinBox;
class QSlider;

namespace dewpoint::ui {

/// One parameter: label, slider and exact number with unit.
class ParameterRow : public QWidget {
  Q_OBJECT
public:
  explicit ParameterRow(const ParameterDeclaration& declaration, QWidget* parent = nullptr);

  const std::string& key() const { return declaration_.key; }
  /// Shows a value without announcing it.
  void setValue(double value);

Q_SIGNALS:
  /// The user moved the slider or typed a number.
  void valueEdited(double value);

private:
  double fromSlider(int position) const;
  int toSlider(double value) const;
  QString tooltip() const;

  const ParameterDeclaration& declaration_; ///< declarations live for ever
  QSlider* slider_;
  QDoubleSpinBox* box_;
};

} // namespace dewpoint::ui
