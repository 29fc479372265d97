// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QStringList>

class QComboBox;
class QWidget;

namespace dewpoint::ui {

/// A choice with this object name, which may be narrower than its longest text.
QComboBox* makeChoice(const char* name, QWidget* parent);

/// Gives a choice other texts, which nobody is told; the same row stays chosen, or the first.
void setTexts(QComboBox& box, const QStringList& texts);

} // namespace dewpoint::ui
