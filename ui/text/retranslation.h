// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <functional>

class QWidget;

namespace dewpoint::ui {

/// Runs `retranslate` now and whenever the language changes, as long as `widget` lives: for
/// every setText(tr(...)) of a widget that outlives a change of language.
void onRetranslate(QWidget* widget, std::function<void()> retranslate);

} // namespace dewpoint::ui
