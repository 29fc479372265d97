// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QStringList>

class QComboBox;
class QWidget;

namespace dewpoint::ui {

/// Creates a combo box with this object name that may be narrower than its longest text.
QComboBox* makeChoice(const char* name, QWidget* parent);

/// Replaces the texts of a combo box without emitting signals; keeps the selected row, else selects
/// the first.
void setTexts(QComboBox& box, const QStringList& texts);

} // namespace dewpoint::ui
