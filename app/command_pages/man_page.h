// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_pages/declared_command.h"

#include <string>

namespace dewpoint::app {

/// A page for man(1), section 1, as roff in UTF-8. The commands of a program stand in it one after
/// the other. `seeAlso`: the other page.
std::string manPage(const DeclaredCommand& program, const std::string& version,
                    const std::string& seeAlso);

} // namespace dewpoint::app
