// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <QString>
#include <QStringList>

#include <cstddef>

namespace dewpoint::ui {

/// Returns the description of a disagreement between cameras, for example "left is about 0.20 s
/// late." `names` are the names of all cameras.
QString disagreementText(const CameraDisagreement& found, const QStringList& names);

/// Returns the text of one way to correct a disagreement between cameras, for example "Swap left
/// and right". `choice` is the index of this way, below `repairChoiceCount()`. The text is used for
/// a button and for the undoable step.
QString rigCorrectionText(const CameraDisagreement& found, std::size_t choice,
                          const QStringList& names);

} // namespace dewpoint::ui
