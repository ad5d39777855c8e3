// SPDX-License-Identifier: Apache-2.0
// What a backend must do, and how one is chosen.
#pragma once

#include <string_view>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/osd/buffer.h>

namespace SolidSubdiv::Osd {

/// Applies rows [begin, end) of a table: row i goes to element i of `destination`. Nothing else is written, and of
/// the source nothing but its elements is read; a row without weights gives 0.
/// @pre views are checked (see Evaluator), source and destination do not overlap
template <class Real>
using EvalStencilsFunction = void (*)(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
                                      const BufferView<Real>& destination, Index begin, Index end);

/// One way to evaluate. The list is in backends.h.
class Backend {
  public:
    constexpr Backend(std::string_view name, EvalStencilsFunction<float> f, EvalStencilsFunction<double> d)
        : name_(name), eval_float_(f), eval_double_(d) {}

    std::string_view name() const { return name_; }

    template <class Real>
    EvalStencilsFunction<Real> eval() const {
        if constexpr (sizeof(Real) == sizeof(float)) {
            return eval_float_;
        } else {
            return eval_double_;
        }
    }

    /// The plain loop in double precision: the truth that other backends are held to.
    static const Backend& Reference();
    /// The fastest on this machine.
    static const Backend& Best();

  private:
    std::string_view name_;
    EvalStencilsFunction<float> eval_float_;
    EvalStencilsFunction<double> eval_double_;
};

}  // namespace SolidSubdiv::Osd
