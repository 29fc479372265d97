// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

namespace dewpoint::ui {

/// The languages that have a catalog (translations/), by their two letters: "de", "en", "es", ...
QStringList languages();

/// From now on the application speaks this language: its own texts, Qt's, and the form of numbers.
/// Empty: the system's. English stands in for a language without a catalog. All
/// widgets get (QEvent::LanguageChange).
void useLanguage(const QString& language);

} // namespace dewpoint::ui
