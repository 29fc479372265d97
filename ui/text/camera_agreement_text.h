// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

#include <QString>
#include <QStringList>

#include <cstddef>

namespace dewpoint::ui {

/// What is wrong: "left is about 0.20 s late." `names`: of all cameras.
QString disagreementText(const CameraDisagreement& found, const QStringList& names);

/// What one of the ways to mend it does (mendingChoices()): "Swap left and right". A button, and
/// the name of the step that can be taken back.
QString mendingText(const CameraDisagreement& found, std::size_t choice, const QStringList& names);

} // namespace dewpoint::ui
