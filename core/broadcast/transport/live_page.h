// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/transport/page_texts.h"

#include <string>

namespace dewpoint::broadcast {

/// Returns the page that shows cameras, targets and their tracks in 3D. It is read-only, needs no
/// other file, and reads JSON lines from the WebSocket of the server that it comes from.
std::string livePage(const PageTexts& texts = {});

} // namespace dewpoint::broadcast
