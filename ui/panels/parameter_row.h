// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSlider;
class QToolButton;

namespace dewpoint::ui {

/// Row for one parameter: label, slider, and number with unit. A value that differs from its
/// default has a dot and a reset button. Pressing Backspace or Delete on the slider also resets it.
class ParameterRow : public QWidget {
  Q_OBJECT
public:
  explicit ParameterRow(const ParameterDeclaration& declaration, QWidget* parent = nullptr);

  const std::string& key() const { return declaration_.key; }
  /// Shows a value without emitting `valueEdited()`.
  void setValue(double value);
  /// Sets whether the value differs from the default, and shows the default.
  void setChanged(bool changed, double defaultValue);
  /// Shows a short note below the value. An empty string removes the note.
  void setNote(const QString& note);

Q_SIGNALS:
  /// Emitted when the user moves the slider or enters a number.
  void valueEdited(double value);
  /// Emitted when the user requests the default value.
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

  const ParameterDeclaration& declaration_; ///< declarations are never deleted
  QSlider* slider_;
  QDoubleSpinBox* box_;
  QLabel* dot_;
  QToolButton* reset_;
  QLabel* note_;
};

} // namespace dewpoint::ui
