// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QStringList>
#include <QVariant>

#include <utility>
#include <vector>

class QComboBox;
class QWidget;

namespace dewpoint::ui {

/// Creates a combo box with this object name that may be narrower than its longest text.
QComboBox* makeChoice(const char* name, QWidget* parent);

/// Gives a choice other texts without emitting signals; the same row stays chosen, or the first.
void setChoices(QComboBox& box, const QStringList& texts);
/// The same of texts with data.
using ChoicesWithData = std::vector<std::pair<QString, QVariant>>;
void setChoicesWithData(QComboBox& box, const ChoicesWithData& choices);

} // namespace dewpoint::ui
