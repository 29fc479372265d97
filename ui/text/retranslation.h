// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <functional>

class QWidget;

namespace dewpoint::ui {

/// Calls `retranslate` now and after every language change while `widget` exists. Use it for every
/// setText(tr(...)) of a widget that outlives a language change.
void onRetranslate(QWidget* widget, std::function<void()> retranslate);

} // namespace dewpoint::ui
