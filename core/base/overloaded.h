// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dewpoint::base {

/// A visitor made of one function per alternative of a variant; the compiler names the alternatives
/// that have none.
template <class... Functions> struct Overloaded : Functions... { using Functions::operator()...; };
template <class... Functions> Overloaded(Functions...) -> Overloaded<Functions...>; // for clang 14

} // namespace dewpoint::base
