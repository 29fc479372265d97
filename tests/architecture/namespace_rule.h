// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>

namespace dewpoint::tests {

/// The namespace that a source file has to open: "dewpoint::base" for "core/base/time.h"; the
/// window and the programs have one each. Empty where none is asked for.
std::string namespaceOf(const std::string& path);

/// Whether a file opens that namespace, or one inside it. Two types of one name in two floors are
/// linked into one program: only their namespaces keep them apart, and no linker warns of it.
bool opensItsNamespace(const std::string& path, std::string_view text);

} // namespace dewpoint::tests
