// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSlider;
class QToolButton;

namespace dewpoint::ui {

/// One parameter: label, slider and exact number with unit; what differs from its default has a dot
/// and a button that resets it, as Backspace and Delete on the slider do.
class ParameterRow : public QWidget {
  Q_OBJECT
public:
  explicit ParameterRow(const ParameterDeclaration& declaration, QWidget* parent = nullptr);

  const std::string& key() const { return declaration_.key; }
  /// Shows a value without announcing it.
  void setValue(double value);
  /// Marks the value as another one than this default.
  void setChanged(bool changed, double defaultValue);
  /// A few words about the value, below it; empty: none.
  void setNote(const QString& note);

Q_SIGNALS:
  /// The user moved the slider or typed a number.
  void valueEdited(double value);
  /// The user wants the default.
  void resetRequested();

protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void layOut(QLabel* label);
  void applyPalette();
  double fromSlider(int position) const;
  int toSlider(double value) const;
  QString tooltip() const;

  const ParameterDeclaration& declaration_; ///< declarations live for ever
  QSlider* slider_;
  QDoubleSpinBox* box_;
  QLabel* dot_;
  QToolButton* reset_;
  QLabel* note_;
};

} // namespace dewpoint::ui
