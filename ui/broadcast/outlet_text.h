// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/transport/outlet.h"

#include <QString>

namespace dewpoint::ui {

/// Returns where the results of an output go: "JSON lines at 127.0.0.1:9001".
QString outletPlace(const broadcast::OutletReport& report);
/// Returns why an output sends nothing at the moment, or an empty text if nothing is wrong.
QString outletProblem(const broadcast::OutletReport& report);

} // namespace dewpoint::ui
