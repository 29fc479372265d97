// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QLocale>
#include <QString>

#include <optional>
#include <variant>

namespace dewpoint::ui {

/// Position in a run that the user enters: a frame, counted from 0, or a time in seconds.
using EnteredPosition = std::variant<qint64, double>;

/// Parses a position in a run: "132" is the frame that the window shows as 132, and "2.5 s" is a
/// time. Numbers may be written as in `locale` or as in English. Returns nothing if the text is
/// neither a frame nor a time.
std::optional<EnteredPosition> parseEnteredPosition(const QString& text, const QLocale& locale);

} // namespace dewpoint::ui
