// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_pages/declared_command.h"

#include <string>

namespace dewpoint::app {

/// Returns the manual page of a program for man(1), section 1, as roff in UTF-8. The page lists the
/// commands one after the other. `seeAlso` is the name of another manual page to refer to.
std::string manPage(const DeclaredCommand& program, const std::string& version,
                    const std::string& seeAlso);

} // namespace dewpoint::app
