// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dewpoint::base {

/// Visitor made of one function per alternative of a variant. Compilation fails if an alternative
/// has no function, and the compiler names it.
template <class... Functions> struct Overloaded : Functions... { using Functions::operator()...; };
template <class... Functions> Overloaded(Functions...) -> Overloaded<Functions...>; // for Clang 14

} // namespace dewpoint::base
