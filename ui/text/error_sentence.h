// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::base {
struct Error;
} // namespace dewpoint::base

namespace dewpoint::ui {

/// Returns the translated sentence for an error. File, field and details stay unchanged.
QString errorText(const Error& error);

} // namespace dewpoint::ui
