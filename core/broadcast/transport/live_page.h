// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/transport/page_texts.h"

#include <string>

namespace dewpoint::broadcast {

/// Returns the HTML page that shows cameras, targets and their tracks in 3D. The page is
/// self-contained. It reads JSON lines from the WebSocket of the server that it was loaded from,
/// and sends no commands.
std::string livePage(const PageTexts& texts = {});

} // namespace dewpoint::broadcast
