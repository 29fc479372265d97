// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace dewpoint::tests {

/// Ends the process, with the reason, unless the condition holds.
void expect(bool condition, const char* what);

/// Ends the process unless the error is one plain sentence that names a file.
void expectPlain(const Error& error);

} // namespace dewpoint::tests
