// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dewpoint::base {

/// Visitor for std::visit, built from one function per alternative of a variant. If an alternative
/// has no function, compilation fails with an error that names the alternative.
template <class... Functions> struct Overloaded : Functions... { using Functions::operator()...; };
template <class... Functions> Overloaded(Functions...) -> Overloaded<Functions...>; // for Clang 14

} // namespace dewpoint::base
