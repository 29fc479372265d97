// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

namespace dewpoint::ui {

/// Languages that have a catalog (translations/), as two letters: "de", "en", "es", ...
QStringList languages();

/// Changes the language of the application: its own texts, those of Qt, and the number format.
/// Empty: the language of the system. English replaces a language without a catalog. All widgets
/// receive QEvent::LanguageChange.
void useLanguage(const QString& language);

} // namespace dewpoint::ui
