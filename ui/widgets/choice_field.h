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

/// Creates a combo box with this object name. It may be narrower than its longest text.
QComboBox* makeChoiceField(const char* name, QWidget* parent);

/// Adds the possible rotations of a camera image, 0 to 270 degrees, to a combo box. Their data is
/// the angle in degrees, as in ProjectCamera::rotateDegrees.
void addRotationChoices(QComboBox& box);

/// Replaces the texts of a combo box without emitting signals. Keeps the selected row if it still
/// exists; otherwise selects the last row.
void setChoices(QComboBox& box, const QStringList& texts);
/// Texts with associated data, for a combo box.
using ChoicesWithData = std::vector<std::pair<QString, QVariant>>;
/// Replaces the texts and data of a combo box without emitting signals. Keeps the selected row if
/// it still exists; otherwise selects the last row.
void setChoicesWithData(QComboBox& box, const ChoicesWithData& choices);

} // namespace dewpoint::ui
