// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::base {
struct Error;
} // namespace dewpoint::base

namespace dewpoint::ui {

/// Returns a translated sentence for an error. The file, the field and the details in the sentence
/// are not translated.
QString errorText(const Error& error);

} // namespace dewpoint::ui
