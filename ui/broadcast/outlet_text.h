// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/transport/outlet.h"

#include <QString>

namespace dewpoint::ui {

/// Returns the format and the destination of an output, for example "JSON lines at 127.0.0.1:9001".
QString outletAddress(const broadcast::OutletReport& report);
/// Returns the reason why an output currently sends nothing, or an empty text if there is no
/// problem.
QString outletProblem(const broadcast::OutletReport& report);

} // namespace dewpoint::ui
