// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

namespace dewpoint::ui {

/// Returns the two-letter codes of the languages that have a catalog (translations/): "de", "en",
/// "es", ...
QStringList availableLanguages();

/// Returns the BCP 47 tag of the language that the texts of the application are in, for example
/// "de-DE"; "en" if no catalog is in use.
QString currentLanguageTag();

/// Changes the language of the application: its own texts, those of Qt, and the number format. An
/// empty string selects the system language. A language without a catalog is replaced by English.
/// All widgets receive QEvent::LanguageChange.
void useLanguage(const QString& language);

} // namespace dewpoint::ui
