// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/transport/page_texts.h"

namespace dewpoint::ui {

/// Returns the texts of the web page that shows the results in a browser, in the language of the
/// application.
broadcast::PageTexts pageTexts();

} // namespace dewpoint::ui
